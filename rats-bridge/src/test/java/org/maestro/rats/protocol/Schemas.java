package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SpecVersion;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.io.InputStream;
import java.util.Set;

/** The shipped JSON Schemas, from the class path only. */
public final class Schemas {

  private static final String ADDRESS = "https://w3id.org/maestro/rats/1/";
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final JsonSchemaFactory factory =
      JsonSchemaFactory.getInstance(
          SpecVersion.VersionFlag.V202012,
          builder ->
              builder.schemaMappers(
                  mappers -> mappers.mapPrefix(ADDRESS, "classpath:org/maestro/rats/protocol/")));

  void assertValid(String schema, byte[] message) throws IOException {
    assertThat(faults(schema, message)).isEmpty();
  }

  Set<ValidationMessage> faults(String schema, byte[] message) throws IOException {
    return faults(schema + ".json", MAPPER.readTree(message));
  }

  /**
   * @param schema a file, or a part of one
   */
  public Set<ValidationMessage> faults(String schema, JsonNode instance) {
    JsonSchema loaded = factory.getSchema(SchemaLocation.of(ADDRESS + schema));
    return loaded.validate(instance);
  }

  public static JsonNode document(String name) throws IOException {
    try (InputStream stream = WireFormat.class.getResourceAsStream(name)) {
      return MAPPER.readTree(stream);
    }
  }
}
