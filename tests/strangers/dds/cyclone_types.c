#include "cyclone_types.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// What a field takes: see CountedValues of counted_values.h, which does the same in C++.

static void real(unsigned* n, double* v) {
  const unsigned i = (*n)++;
  *v = (i % 2 == 1 ? -1 : 1) * (i + 0.25);
}
static void real32(unsigned* n, float* v) {
  double wide;
  real(n, &wide);
  *v = (float)wide;
}
static void uint32(unsigned* n, uint32_t* v) { *v = (*n)++ * 0x01020304U; }
static void uint64(unsigned* n, uint64_t* v) { *v = (*n)++ * 0x0102030405060708ULL; }
static void int32(unsigned* n, int32_t* v) { *v = (int32_t)((*n)++ * 0x01020304U); }
static void uint16(unsigned* n, uint16_t* v) { *v = (uint16_t)((*n)++ * 257); }
static void int8(unsigned* n, int8_t* v) { *v = (int8_t)(*n)++; }
static void octet(unsigned* n, uint8_t* v) { *v = (uint8_t)(*n)++; }
static void character(unsigned* n, char* v) { *v = (char)(*n)++; }
static void boolean(unsigned* n, bool* v) { *v = (*n)++ % 2 == 1; }
static void short_text(unsigned* n, char* v) {
  const unsigned letters = (*n)++ % 9;
  memcpy(v, "abcdefgh", letters);
  v[letters] = 0;
}
static void text(unsigned* n, char** v) {
  *v = dds_string_alloc(8);
  short_text(n, *v);
}
#define ARRAY(field, put) \
  for (size_t i = 0; i < sizeof(field) / sizeof((field)[0]); ++i) put(n, &(field)[i])
#define SEQUENCE(field, type, put)                                                        \
  do {                                                                                    \
    (field)._length = (field)._maximum = (*n)++ % 3;                                      \
    (field)._release = true;                                                              \
    if ((field)._length > 0) (field)._buffer = dds_alloc((field)._length * sizeof(type)); \
    for (uint32_t i = 0; i < (field)._length; ++i) put(n, &(field)._buffer[i]);           \
  } while (0)

#include "cyclone_fields.inc"

#define CASE(package, kind, name)                                          \
  {#package "/" #kind "/" #name, #package "::" #kind "::dds_::" #name "_", \
   &package##_##kind##_##name##_desc,                                      \
   (void (*)(unsigned*, void*))(void (*)(void))fill_##package##_##kind##_##name},
const struct cyclone_type cyclone_types[] = {SLACKWATER_EVERY_TYPE(CASE){NULL, NULL, NULL, NULL}};

const struct cyclone_type* cyclone_type_named(const char* ros_name) {
  for (const struct cyclone_type* type = cyclone_types; type->ros_name != NULL; ++type)
    if (strcmp(type->ros_name, ros_name) == 0) return type;
  return NULL;
}

dds_entity_t topic_of(dds_entity_t participant, const struct cyclone_type* type,
                      const char* dds_topic) {
  dds_topic_descriptor_t named = *type->descriptor;
  // The field is const; a descriptor under another name is what is wanted.
  *(const char**)(void*)&named.m_typename = type->dds_name;
  return dds_create_topic(participant, &named, dds_topic, NULL, NULL);
}
