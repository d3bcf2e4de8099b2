#!/bin/bash
# Builds what counting instructions needs, in a folder of its own: Mesa's drivers for Intel and AMD as Debian builds them, unpacked there and
# not installed; the two libraries that pretend to be their devices (`drm-shim`, some files of C from Mesa's source, without meson); and the
# program that compiles shaders with them. Nothing outside the folder changes.
#
#   tools/instructions/compilers/build.sh FOLDER
#
# Debian 12 or 13 on x86-64 with gcc, python3-mako, libdrm-dev, libegl-dev, libgles-dev and libllvm15 (Debian 13: libllvm19), and apt with `deb` and
# `deb-src` of a suite that has Mesa 25.0: bookworm-backports or trixie. APT_CONFIG may name a configuration of apt that has them.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
version=${MESA_VERSION:-25.0.7}
suite=$(apt-cache madison mesa-libgallium | awk -F' *[|] *' -v version="$version" '$2 ~ version { split($3, words, " "); sub("/.*", "", words[2]); print words[2]; exit }')
[ -n "$suite" ] || { echo "apt knows no Mesa $version: give it deb and deb-src of a suite that has it." >&2; exit 1; }
cd "$folder"

mkdir -p packages drivers shims objects generated/intel/dev
if ! ls drivers/usr/lib/*/libgallium-* > /dev/null 2>&1; then
  (cd packages && apt-get download -qq {mesa-libgallium,libegl-mesa0,libgbm1,libdrm2,libdrm-amdgpu1,libdrm-intel1}/"$suite")
  for package in packages/*.deb; do dpkg-deb -x "$package" drivers; done
fi
libraries=$(dirname "$folder/$(ls drivers/usr/lib/*/libgallium-* | head -1)")
lacking=$(LD_LIBRARY_PATH="$libraries" ldd "$libraries"/libgallium-* "$libraries"/libEGL_mesa.so.0 | awk '/not found/ { print $1 }' | sort -u)
[ -z "$lacking" ] || { echo "Install what holds these libraries: $lacking" >&2; exit 1; }

mesa=$folder/mesa-$version
if [ ! -d "$mesa" ]; then
  ls mesa_"$version".orig.tar.xz > /dev/null 2>&1 || apt-get source -qq --download-only --tar-only mesa/"$suite"
  tar xf mesa_"$version".orig.tar.xz mesa-"$version"/{include,src/{drm-shim,amd,intel,util,c11,compiler,mesa,gallium/include,gallium/auxiliary}}
fi
devices=$mesa/src/intel/dev
made=generated/intel/dev
/usr/bin/python3 "$devices/gen_wa_helpers.py" "$devices/mesa_defs.json" $made/intel_wa.h $made/intel_wa.c
/usr/bin/python3 "$devices/intel_device_info_gen_h.py" $made/intel_device_info_gen.h
# Devices that a file of JSON describes are not needed, nor is a parser for it.
cat > generated/noJson.c << 'C'
#include <stdbool.h>
struct intel_device_info;
bool intel_device_info_from_json(const char *path, struct intel_device_info *device) { return false; }
C

flags=(-std=gnu11 -O1 -w -fPIC -fvisibility=hidden -pthread -ffunction-sections -fdata-sections -DNDEBUG -D_GNU_SOURCE -D_FILE_OFFSET_BITS=64
  -DUTIL_ARCH_LITTLE_ENDIAN=1 -DMAJOR_IN_SYSMACROS '-DPACKAGE_VERSION="-"' '-DPACKAGE_BUGREPORT="-"')
for feature in PTHREAD LINUX_FUTEX_H ENDIAN_H DLFCN_H STRUCT_TIMESPEC TIMESPEC_GET LIBDRM PROGRAM_INVOCATION_NAME POSIX_MEMALIGN MEMFD_CREATE \
  DIRENT_D_TYPE REALLOCARRAY SECURE_GETENV GETRANDOM __BUILTIN_{EXPECT,CLZ,CLZLL,CTZ,FFS,FFSLL,POPCOUNT,POPCOUNTLL,UNREACHABLE,BSWAP32,BSWAP64} \
  __BUILTIN_TYPES_COMPATIBLE_P FUNC_ATTRIBUTE_{CONST,PURE,PACKED,FORMAT,UNUSED,NORETURN,VISIBILITY,RETURNS_NONNULL,MALLOC,ALIAS,FLATTEN,WARN_UNUSED_RESULT,WEAK}; do
  flags+=("-DHAVE_$feature")
done
for path in include src src/{amd,intel,intel/dev,intel/common,util,gallium/include,gallium/auxiliary,mesa}; do flags+=("-I$mesa/$path"); done
flags+=(-Igenerated -Igenerated/intel -I$made -I/usr/include/libdrm)

# Arguments: the name of the library, and its sources without `.c`, in Mesa's source or here. Those that this version lacks are left out.
build_shim() {
  local name=$1 objects=() source
  shift
  for source in "$@"; do
    [ -f "$mesa/src/$source.c" ] && source=$mesa/src/$source
    [ -f "$source.c" ] || continue
    objects+=("objects/$name-${#objects[@]}.o")
    gcc "${flags[@]}" -c "$source.c" -o "${objects[-1]}"
  done
  gcc -shared -o "shims/$name.so" "${objects[@]}" -Wl,--gc-sections -Wl,-z,defs -ldl -lpthread -lm
}
shared=(drm-shim/{device,drm_shim} util/{hash_table,set,ralloc,vma,log,os_misc,os_time,os_file,u_debug,u_process,u_printf,anon_file,simple_mtx}
  util/{futex,u_call_once,u_math,half_float,double,softfloat,blob,memstream,strtod})
build_shim amd "${shared[@]}" amd/drm-shim/amdgpu_{noop_drm_shim,devices}
build_shim intel "${shared[@]}" intel/tools/intel_noop_drm_shim intel/dev/intel_{device_info,hwconfig,kmd,debug} intel/dev/{i915,xe}/intel_device_info \
  intel/common/intel_{gem,engine} intel/common/{i915,xe}/intel_{gem,engine} intel/common/xe/intel_device_query $made/intel_wa generated/noJson
gcc -O1 -Wall -Wno-unused-result -o printCode "$here/printCode.c" -lEGL -lGLESv2
ln -sfn "${libraries#"$folder"/}" libraries

# Which drivers answer.
export GALLIUM_THREAD=0 MESA_SHADER_CACHE_DISABLE=1
LD_LIBRARY_PATH=$libraries LD_PRELOAD=$folder/shims/intel.so INTEL_STUB_GPU_PLATFORM=tgl ./printCode 2> /dev/null
LD_LIBRARY_PATH=$libraries LD_PRELOAD=$folder/shims/amd.so AMDGPU_GPU_ID=navi21 AMD_DEBUG=useaco ./printCode 2> /dev/null
