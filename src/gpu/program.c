#include "gpu/program.h"

#include "base/file.h"
#include "base/log.h"
#include "base/resource.h"

#include <stdlib.h>
#include <string.h>

#define SHADER_SIZE_MAX (1 << 20) /* bytes of one file */
#define INCLUDES_MAX 16
#define STAGES_MAX 3 /* of a program */

#define ES_PRECISIONS                                                                                                  \
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler2DArray;\n"

static const char *const dialect_lines[] = {
    [PROGRAM_GL33] = "#version 330 core\n",
    [PROGRAM_ES30] = "#version 300 es\n" ES_PRECISIONS,
    [PROGRAM_GL43] = "#version 430 core\n",
    [PROGRAM_ES31] = "#version 310 es\n" ES_PRECISIONS,
};

static const struct {
    const char *define;
    GLenum shader;
} stages[] = {
    [PROGRAM_VERTEX] = {"VERTEX", GL_VERTEX_SHADER},
    [PROGRAM_FRAGMENT] = {"FRAGMENT", GL_FRAGMENT_SHADER},
    [PROGRAM_COMPUTE] = {"COMPUTE", GL_COMPUTE_SHADER},
    [PROGRAM_GEOMETRY] = {"GEOMETRY", GL_GEOMETRY_SHADER},
};

/* A text that is being put together from files. */
struct assembly {
    FILE *out;
    const char *shader_folder;
    const struct dpl_log *log;
    char included[INCLUDES_MAX][128];
    int included_count;
};

static char *read_shader(const struct assembly *assembly, const char *path)
{
    if (assembly->shader_folder) {
        char full[4096];
        size_t length;
        snprintf(full, sizeof full, "%s/%s", assembly->shader_folder, path);
        return file_read(full, SHADER_SIZE_MAX, &length, assembly->log);
    }
    const char *text = base_resource_find(path);
    if (!text)
        base_fail(assembly->log, DPL_REASON_SHADER, "%s: no such shader is built in", path);
    return text ? strdup(text) : NULL;
}

static bool is_included(const struct assembly *assembly, const char *path)
{
    for (int i = 0; i < assembly->included_count; i++)
        if (!strcmp(assembly->included[i], path))
            return true;
    return false;
}

static bool append_file(struct assembly *assembly, const char *path)
{
    if (is_included(assembly, path))
        return true;
    if (assembly->included_count == INCLUDES_MAX)
        return base_fail(assembly->log, DPL_REASON_SHADER, "%s: one file too many in a shader (at most %d)", path,
                         INCLUDES_MAX);
    snprintf(assembly->included[assembly->included_count++], sizeof assembly->included[0], "%s", path);
    char *text = read_shader(assembly, path);
    if (!text)
        return false;
    int file = assembly->included_count;
    bool ok = true;
    int number = 1;
    fprintf(assembly->out, "#line 1 %d\n", file);
    for (char *line = text, *next; ok && *line; line = next, number++) {
        char name[128];
        next = line + strcspn(line, "\n");
        next += *next == '\n';
        if (sscanf(line, "#include \"%127[^\"\n]\"", name) == 1) {
            ok = append_file(assembly, name);
            fprintf(assembly->out, "#line %d %d\n", number + 1, file);
        } else {
            fwrite(line, 1, (size_t)(next - line), assembly->out);
        }
    }
    free(text);
    return ok;
}

static char *assemble(struct assembly *assembly, const char *path, enum program_dialect dialect,
                      enum program_stage stage, const char *defines)
{
    char *source = NULL;
    size_t size = 0;
    assembly->out = open_memstream(&source, &size);
    if (!assembly->out)
        return NULL;
    fprintf(assembly->out, "%s#define %s\n%s", dialect_lines[dialect], stages[stage].define, defines);
    bool ok = append_file(assembly, path);
    if (fclose(assembly->out) == 0 && ok)
        return source;
    free(source);
    return NULL;
}

char *program_source(const char *path, const char *shader_folder, enum program_dialect dialect,
                     enum program_stage stage, const char *defines, const struct dpl_log *log)
{
    struct assembly assembly = {.shader_folder = shader_folder, .log = log};
    return assemble(&assembly, path, dialect, stage, defines);
}

/* Reports what the driver said; "2:17" there means line 17 of the second file of the list. */
static bool report(struct dpl_gl *gl, const char *path, const struct assembly *assembly, const char *said)
{
    char files[512] = "";
    for (int i = 0; i < assembly->included_count; i++) {
        size_t used = strlen(files);
        snprintf(files + used, sizeof files - used, " %d = %s", i + 1, assembly->included[i]);
    }
    return base_fail(gl->log, DPL_REASON_SHADER, "%s: %s (files:%s)", path, said, files);
}

static GLuint compile_stage(struct dpl_gl *gl, const char *path, enum program_stage stage, const char *defines)
{
    static const enum program_dialect dialects[2][2] = {{PROGRAM_GL33, PROGRAM_GL43}, {PROGRAM_ES30, PROGRAM_ES31}};
    struct assembly assembly = {.shader_folder = gl->shader_folder, .log = gl->log};
    char *source = assemble(&assembly, path, dialects[gl->info.es][gl->info.compute], stage, defines);
    if (!source)
        return 0;
    GLuint shader = gl->CreateShader(stages[stage].shader);
    const GLchar *text = source;
    gl->ShaderSource(shader, 1, &text, NULL);
    gl->CompileShader(shader);
    free(source);
    GLint compiled = 0;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    char said[512] = "";
    gl->GetShaderInfoLog(shader, sizeof said, NULL, said);
    gl->DeleteShader(shader);
    report(gl, path, &assembly, said);
    return 0;
}

static GLuint link_stages(struct dpl_gl *gl, const char *path, const GLuint *shaders, int count)
{
    GLuint name = gl->CreateProgram();
    for (int i = 0; i < count; i++)
        gl->AttachShader(name, shaders[i]);
    gl->LinkProgram(name);
    GLint linked = 0;
    gl->GetProgramiv(name, GL_LINK_STATUS, &linked);
    if (linked)
        return name;
    char said[512] = "";
    gl->GetProgramInfoLog(name, sizeof said, NULL, said);
    gl->DeleteProgram(name);
    base_fail(gl->log, DPL_REASON_SHADER, "%s: does not link: %s", path, said);
    return 0;
}

static GLuint build(struct dpl_gl *gl, const char *path, const char *defines, const enum program_stage *stage,
                    int count)
{
    GLuint shaders[STAGES_MAX] = {0};
    int made = 0;
    while (made < count && (shaders[made] = compile_stage(gl, path, stage[made], defines)))
        made++;
    GLuint name = made == count ? link_stages(gl, path, shaders, count) : 0;
    for (int i = 0; i < made; i++)
        gl->DeleteShader(shaders[i]);
    return name;
}

/* Leaves the program as it was where a stage fails. */
static bool ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines,
                  const enum program_stage *stage, int count)
{
    GLuint name = program->generation != gl->generation ? build(gl, path, defines, stage, count) : 0;
    program->generation = gl->generation;
    if (name) {
        gl->DeleteProgram(program->name);
        program->name = name;
    }
    return program->name != 0;
}

bool program_ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines)
{
    static const enum program_stage drawing[] = {PROGRAM_VERTEX, PROGRAM_FRAGMENT};
    return ready(gl, program, path, defines, drawing, 2);
}

bool program_geometry_ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines)
{
    static const enum program_stage drawing[] = {PROGRAM_VERTEX, PROGRAM_GEOMETRY, PROGRAM_FRAGMENT};
    return ready(gl, program, path, defines, drawing, 3);
}

bool program_compute_ready(struct dpl_gl *gl, struct gpu_program *program, const char *path, const char *defines)
{
    static const enum program_stage compute[] = {PROGRAM_COMPUTE};
    return ready(gl, program, path, defines, compute, 1);
}

void program_finish(struct dpl_gl *gl, struct gpu_program *program)
{
    gl->DeleteProgram(program->name);
    *program = (struct gpu_program){0};
}

void program_use(struct dpl_gl *gl, const struct gpu_program *program)
{
    gl->UseProgram(program->name);
}

void program_int(struct dpl_gl *gl, const struct gpu_program *program, const char *name, int value)
{
    gl->Uniform1i(gl->GetUniformLocation(program->name, name), value);
}

void program_float(struct dpl_gl *gl, const struct gpu_program *program, const char *name, double value)
{
    gl->Uniform1f(gl->GetUniformLocation(program->name, name), (GLfloat)value);
}

void program_ivec2(struct dpl_gl *gl, const struct gpu_program *program, const char *name, int x, int y)
{
    gl->Uniform2i(gl->GetUniformLocation(program->name, name), x, y);
}

void program_vec2(struct dpl_gl *gl, const struct gpu_program *program, const char *name, double x, double y)
{
    gl->Uniform2f(gl->GetUniformLocation(program->name, name), (GLfloat)x, (GLfloat)y);
}

void program_vec3(struct dpl_gl *gl, const struct gpu_program *program, const char *name, const double value[3])
{
    gl->Uniform3f(gl->GetUniformLocation(program->name, name), (GLfloat)value[0], (GLfloat)value[1], (GLfloat)value[2]);
}

void program_vec4s(struct dpl_gl *gl, const struct gpu_program *program, const char *name, int count,
                   const float *values)
{
    gl->Uniform4fv(gl->GetUniformLocation(program->name, name), count, values);
}

void program_mat4(struct dpl_gl *gl, const struct gpu_program *program, const char *name, const float *columns)
{
    gl->UniformMatrix4fv(gl->GetUniformLocation(program->name, name), 1, GL_FALSE, columns);
}
