package org.maestro.console.api;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/** The schemas of what the API takes and answers. */
final class Schemas {
  private static final String OWN = "#/$defs/";
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private Schemas() {}

  /** What it refers to within itself is elsewhere in the document. */
  private static void place(JsonNode node, String definitions) {
    String reference = node.path("$ref").asText();
    if (node instanceof ObjectNode object && reference.startsWith(OWN)) {
      object.put("$ref", definitions + reference.substring(OWN.length()));
    }
    node.forEach(part -> place(part, definitions));
  }

  /** A schema as it is within the OpenAPI document, where it has no name of its own. */
  static ObjectNode named(String name) {
    try (InputStream schema =
        Schemas.class.getResourceAsStream("/org/maestro/console/schemas/" + name + ".json")) {
      if (schema == null) {
        throw new IllegalStateException("There is no schema " + name + ".");
      }
      JsonNode node = MAPPER.readTree(schema);
      ObjectNode own = (ObjectNode) node;
      own.remove("$schema");
      own.remove("$id");
      place(own, "#/components/schemas/" + name + "/$defs/");
      return own;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
