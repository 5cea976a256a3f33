#include "step1_shadowmap/base/geometry.h"

#include <cglm/mat3.h> // glm_mat3_inv, glm_mat3_transpose
#include <cglm/mat4.h> // glm_mat4_pick3
#include <stddef.h>    // offsetof

static void upload(const Mesh *mesh, GLuint vertices, GLuint indices)
{
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBufferData(GL_ARRAY_BUFFER,
                 (GLsizeiptr)(mesh->vertex_count * sizeof(MeshVertex)),
                 mesh->vertices, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 (GLsizeiptr)(mesh->index_count * sizeof(uint32_t)),
                 mesh->indices, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          (void *)offsetof(MeshVertex, position));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          (void *)offsetof(MeshVertex, normal));
}

Geometry geometry_create(const Scene *scene)
{
    Geometry geometry = {.vao = {0}};
    glGenVertexArrays(scene->mesh_count, geometry.vao);
    glGenBuffers(scene->mesh_count, geometry.vertices);
    glGenBuffers(scene->mesh_count, geometry.indices);
    for (int i = 0; i < scene->mesh_count; i++) {
        glBindVertexArray(geometry.vao[i]);
        upload(&scene->meshes[i], geometry.vertices[i], geometry.indices[i]);
    }
    return geometry;
}

void geometry_destroy(Geometry *geometry)
{
    // Names that are 0 (meshes the scene does not have) are ignored.
    glDeleteBuffers(SCENE_MAX_MESHES, geometry->indices);
    glDeleteBuffers(SCENE_MAX_MESHES, geometry->vertices);
    glDeleteVertexArrays(SCENE_MAX_MESHES, geometry->vao);
    *geometry = (Geometry){.vao = {0}};
}

// world_from_object with the origin taken away in double, then rounded.
static void relative_matrix(const Object *object, const double origin[3],
                            mat4 relative_from_object)
{
    for (int row = 0; row < 3; row++) {
        const double *m = object->transform[row];
        for (int column = 0; column < 3; column++) {
            relative_from_object[column][row] = (float)m[column];
        }
        relative_from_object[3][row] = (float)(m[3] - origin[row]);
        relative_from_object[row][3] = 0;
    }
    relative_from_object[3][3] = 1;
}

static void set_object_uniforms(const Object *object, const double origin[3],
                                GLuint program)
{
    mat4 relative_from_object;
    mat3 normal_from_object;
    relative_matrix(object, origin, relative_from_object);
    // Normals go with the inverse transpose, else a stretched object's would
    // lean the wrong way.
    glm_mat4_pick3(relative_from_object, normal_from_object);
    glm_mat3_inv(normal_from_object, normal_from_object);
    glm_mat3_transpose(normal_from_object);
    glUniformMatrix4fv(glGetUniformLocation(program, "relative_from_object"), 1,
                       GL_FALSE, relative_from_object[0]);
    glUniformMatrix3fv(glGetUniformLocation(program, "normal_from_object"), 1,
                       GL_FALSE, normal_from_object[0]);
    glUniform3fv(glGetUniformLocation(program, "albedo"), 1, object->albedo);
}

void geometry_draw(const Geometry *geometry, const Scene *scene,
                   const DrawList *list, const double origin[3], GLuint program)
{
    for (int i = 0; i < list->count; i++) {
        const Object *object = &scene->objects[list->objects[i]];
        set_object_uniforms(object, origin, program);
        glBindVertexArray(geometry->vao[object->mesh - scene->meshes]);
        glDrawElements(GL_TRIANGLES, (GLsizei)object->mesh->index_count,
                       GL_UNSIGNED_INT, NULL);
    }
}
