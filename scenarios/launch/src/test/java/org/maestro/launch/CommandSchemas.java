package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The schemas of what commands print with {@code --json}, as the documentation has them. */
public final class CommandSchemas {
  private static final Path DIRECTORY = Path.of("..", "..", "docs", "schemas");
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private CommandSchemas() {}

  static Set<String> names() throws IOException {
    try (Stream<Path> files = Files.list(DIRECTORY)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".json"))
          .map(name -> name.substring(0, name.length() - ".json".length()))
          .collect(Collectors.toCollection(TreeSet::new));
    }
  }

  static JsonNode schema(String name) throws IOException {
    return MAPPER.readTree(Files.readString(DIRECTORY.resolve(name + ".json")));
  }

  /**
   * The one document that was printed, which has to be as its schema says.
   *
   * @param printed all that came on the standard output
   */
  public static JsonNode valid(String name, String printed) throws IOException {
    assertThat(printed.strip().lines()).as(printed).hasSize(1);
    JsonNode document = MAPPER.readTree(printed);
    assertThat(
            JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
                .getSchema(schema(name))
                .validate(document))
        .as("%s: %s", name, printed)
        .isEmpty();
    return document;
  }
}
