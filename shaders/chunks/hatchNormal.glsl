// xyz: the normal smoothed to the scale of a stroke; zero where the geometry has none. w: minus the baked occlusion; 1 where the
// geometry has no such attribute, which is WebGL's default.
attribute vec4 hatchNormal;
