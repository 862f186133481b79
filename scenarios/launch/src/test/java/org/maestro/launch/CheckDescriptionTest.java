package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.HomeLoader;

/** What a device is going to say of itself is checked before it says so. */
class CheckDescriptionTest {

  private static final String BELL =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {"b": "https://example.org/bells#"}],
       "id": "b:bell-1", "type": "maestro:Device",
       "offers": {"id": "b:ring", "type": "maestro:Task",
         "input": {"name": "who", "types": ["domain:Person"]}, "effect": "(called ?who)", "cost": "1"},
       "brings": {"id": "b:called", "type": "maestro:Predicate", "arguments": ["?p - Person"]}}
      """;

  @TempDir private Path directory;

  private String check(String description, String... more) throws IOException {
    Path file = Files.writeString(directory.resolve("bell.json"), description);
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    String[] arguments = new String[more.length + 2];
    arguments[0] = "check";
    arguments[1] = file.toString();
    System.arraycopy(more, 0, arguments, 2, more.length);
    int code = Maestro.commandLine(stream, stream).execute(arguments);
    return code + " " + said.toString(StandardCharsets.UTF_8).replace(directory + "/", "");
  }

  @Test
  void aDescriptionIsCheckedAloneAndAgainstAHome() throws IOException {
    assertThat(check(BELL))
        .isEqualToIgnoringNewLines(
            "0 bell-1 could join, and would offer ring.bell.json: no fault.");
    assertThat(check(BELL, "--home", "bob")).startsWith("0 ");
    String withItem =
        BELL.replace(
                "\"brings\": {",
                "\"brings\": [{\"id\": \"b:clapper\", \"type\": \"domain:Item\"}, {")
            .replace("\"?p - Person\"]}}", "\"?p - Person\"]}]}");
    assertThat(check(withItem, "--home", "bob")).startsWith("0 bell-1 could join");
    assertThat(check(BELL.replace("bell-1", "rose"), "--home", "bob")).startsWith("0 ");
  }

  @Test
  void everyFaultIsToldWithItsCure() throws IOException {
    String faulty =
        BELL.replace("(called ?who)", "(calld ?who)")
            .replace("\"cost\": \"1\"", "\"cost\": \"(+ 1\"");

    assertThat(check(faulty))
        .startsWith("1 ")
        .contains("uses the unknown predicate calld; write called, if that is meant")
        .contains("is not MAESTRO-SL: at column 5")
        .contains("2 faults.");
    assertThat(check(faulty, "--json")).contains("\"cure\":\"write called, if that is meant\"");
    assertThat(check("{\"id\": ")).startsWith("1 bell.json:1: the text has a fault");
  }

  private static String asked(List<String> command) throws IOException, InterruptedException {
    try (JavaProcess asking = JavaProcess.start(Maestro.class.getName(), command)) {
      return asking.await(Duration.ofSeconds(60)).output();
    }
  }

  @Test
  void theRunningPlatformSaysWhetherItCouldJoinNow() throws IOException, InterruptedException {
    try (Stage stage =
        Stage.paced(
            SiteSettings.of(
                    "checked-bells",
                    new HomeLoader().load(Shipped.text("/homes/bob.ttl").orElseThrow(), "bob.ttl"))
                .build())) {
      String main = "127.0.0.1:" + stage.platform().port();

      Path file = directory.resolve("bell.json");
      List<String> command = List.of("check", file.toString(), "--running", "--main", main);
      Files.writeString(file, BELL);
      assertThat(asked(command)).contains("bell-1 could join, and would offer ring.");
      Files.writeString(file, BELL.replace("\"cost\"", "\"ocupies\": [\"clapper\"], \"cost\""));
      assertThat(asked(command))
          .contains(":4: ring ocupies is no word of the context", "write \"occupies\"")
          .contains("bell-1 could join", "no fault, 1 warning.");
      Files.writeString(file, BELL.replace("called", "in"));
      assertThat(asked(command))
          .contains("in has the local name of https://w3id.org/maestro/domain#in");
      assertThat(stage.platform().knowledge().home().devices()).doesNotContainKey("bell-1");
    }
  }

  @Test
  void aHomeHasNoHome() throws IOException {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    int code = Maestro.commandLine(stream, stream).execute("check", "bob", "--home", "arena");

    assertThat(code + " " + said)
        .startsWith("2 maestro: --home and --running go with a description");
  }
}
