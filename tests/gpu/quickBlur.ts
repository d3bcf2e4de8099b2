/**
 * Lets three's PMREMGenerator blur environments with an eighth of its samples: over all of them a software rasterizer takes seconds
 * each time. What is compared is drawn with the same blur.
 */
const { shaderSource } = WebGL2RenderingContext.prototype;
WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
  shaderSource.call(this, shader, source.replace('#define GGX_SAMPLES 256u', '#define GGX_SAMPLES 32u'));
};

export {};
