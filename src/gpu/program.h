/* gpu/program.h: shader programs from files without a version line.
 *
 * A shader file holds both stages, split by the stage's define:
 *
 *     #include "gpu/screen.glsl"      the vertex stage of a pass over the whole target
 *     #ifdef FRAGMENT
 *     out float map;
 *     void main() { … }
 *     #endif
 *
 * with a GEOMETRY stage between them where the file has one; or one compute stage, in a file whose name says so: it is
 * not read for other stages.
 *
 * The loader puts in front: the dialect ("#version 330 core", or "#version 300 es" with its precisions; "430 core" and
 * "310 es" where the device has compute shaders), the stage's define, the caller's defines; and it expands #include
 * "folder/file.glsl", each file once. Files are those built into the library, or those of the folder that
 * dpl_gl_options names; a message keeps file and line. */
#ifndef GPU_PROGRAM_H
#define GPU_PROGRAM_H

#include "gpu/gl.h"

/* All zero: none yet. */
struct gpu_program {
    GLuint name;
    unsigned generation; /* of the shader files that it was last built from; see struct dpl_gl */
};

/* Builds the program where that has not been tried with this generation of shader files. `defines` is text such as
 * "#define STEPS 3\n" or "". On failure, with the reason logged, an earlier program stays (so that a shader that is
 * being edited does not take the picture away). True where there is a program to use. */
bool program_ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines);

/* The same for a program with a geometry stage; the device has geometry shaders. */
bool program_geometry_ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines);

/* The same for a program of one compute stage; the device has compute shaders. */
bool program_compute_ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines);

/* Takes a zeroed one. Leaves it zeroed. */
void program_finish(struct dpl_gl *gl, struct gpu_program *program);

/* Makes it current. */
void program_use(struct dpl_gl *gl, const struct gpu_program *program);

/* Uniforms of the program in use, by name; a name that the compiler dropped is ignored. */
void program_int(struct dpl_gl *gl, const struct gpu_program *program, const char *name, int value);
void program_float(struct dpl_gl *gl, const struct gpu_program *program, const char *name, double value);
void program_ivec2(struct dpl_gl *gl, const struct gpu_program *program, const char *name, int x, int y);
void program_vec2(struct dpl_gl *gl, const struct gpu_program *program, const char *name, double x, double y);
void program_vec3(struct dpl_gl *gl, const struct gpu_program *program, const char *name, const double value[3]);
void program_vec4s(struct dpl_gl *gl, const struct gpu_program *program, const char *name, int count,
                   const float *values);
void program_mat4(struct dpl_gl *gl, const struct gpu_program *program, const char *name, const float *columns);

enum program_dialect { PROGRAM_GL33, PROGRAM_ES30, PROGRAM_GL43, PROGRAM_ES31 };
enum program_stage { PROGRAM_VERTEX, PROGRAM_FRAGMENT, PROGRAM_COMPUTE, PROGRAM_GEOMETRY };

/* The whole text of one stage as it is compiled: what the tests hand to a validator. The caller frees it; NULL, with
 * the reason logged, where a file is missing. */
char *program_source(const char *path, const char *shader_folder, enum program_dialect dialect,
                     enum program_stage stage, const char *defines, const struct dpl_log *log);

#endif
