// cyclone_bytes FOLDER DOMAIN: writes every structure of api/door/dds/idl, filled with counted values,
// as Cyclone DDS has it on the wire: FOLDER/package.kind.Name.FIRST.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cyclone_types.h"
#include "dds/ddsi/ddsi_serdata.h"

static void die(const char* what, const char* of) {
  fprintf(stderr, "cyclone_bytes: %s: %s\n", of, what);
  exit(1);
}

/// A reader takes the bytes before anybody decodes them.
static struct ddsi_serdata* through(dds_entity_t participant, const struct cyclone_type* type,
                                    const void* message) {
  const dds_entity_t topic = topic_of(participant, type, type->ros_name);
  if (topic < 0) die(dds_strretcode(topic), type->ros_name);
  const dds_entity_t reader = dds_create_reader(participant, topic, NULL, NULL);
  const dds_entity_t writer = dds_create_writer(participant, topic, NULL, NULL);
  if (dds_write(writer, message) != DDS_RETCODE_OK) die("cannot be written", type->ros_name);
  struct ddsi_serdata* bytes = NULL;
  dds_sample_info_t info;
  if (dds_takecdr(reader, &bytes, 1, &info, DDS_ANY_STATE) != 1)
    die("was not heard", type->ros_name);
  dds_delete(writer);
  dds_delete(reader);
  dds_delete(topic);
  return bytes;
}

static void write_file(const char* folder, const struct cyclone_type* type, unsigned first,
                       const struct ddsi_serdata* bytes) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s.%u", folder, type->ros_name, first);
  for (char* c = path + strlen(folder) + 1; *c != 0; ++c)
    if (*c == '/') *c = '.';
  FILE* file = fopen(path, "wb");
  if (file == NULL) die("cannot be written", path);
  const uint32_t size = ddsi_serdata_size(bytes);
  void* buffer = malloc(size);
  ddsi_serdata_to_ser(bytes, 0, size, buffer);
  if (fwrite(buffer, 1, size, file) != size || fclose(file) != 0) die("cannot be written", path);
  free(buffer);
}

int main(int argc, char** argv) {
  if (argc != 3) {
    fprintf(stderr, "cyclone_bytes FOLDER DOMAIN\n");
    return 2;
  }
  const dds_entity_t participant =
      dds_create_participant((dds_domainid_t)atoi(argv[2]), NULL, NULL);
  if (participant < 0) die(dds_strretcode(participant), "participant");
  for (const struct cyclone_type* type = cyclone_types; type->ros_name != NULL; ++type) {
    for (unsigned first = 0; first < 8; ++first) {
      unsigned n = first;
      void* message = dds_alloc(type->descriptor->m_size);  // all zero
      type->fill(&n, message);
      struct ddsi_serdata* bytes = through(participant, type, message);
      write_file(argv[1], type, first, bytes);
      ddsi_serdata_unref(bytes);
      dds_sample_free(message, type->descriptor, DDS_FREE_ALL);
    }
  }
  dds_delete(participant);
  return 0;
}
