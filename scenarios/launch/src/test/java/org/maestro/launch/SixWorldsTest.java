package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The sentence of ADE, 4.2, in six worlds: what it means depends on where the glasses are and what
 * the places are like (A61, A62).
 */
class SixWorldsTest {
  private static final String SENTENCE = "put the glass on the floor in the refrigerator";
  private static final String HEAD =
      """
      @base <https://w3id.org/maestro/home/evening> .
      @prefix scene: <https://w3id.org/maestro/scene#> .
      <> scene:latitude 52.3 ; scene:dayOfYear 320 ; scene:solarTime "18:05" .
      <#Dave> scene:position "5.6 3.2 0" ; scene:radius 0.25 .
      """;
  private static final String FLOOR_OF_THE_REFRIGERATOR =
      """
      home:floor-r a :Floor ; rdfs:label "the floor"@en ; :topHeight 0.2 ; :in home:refrigerator ;
        maestro:outline "8.6 3.5, 8.8 3.5, 8.8 3.7, 8.6 3.7" ; maestro:position "8.7 3.6 0.2" .
      """;

  @TempDir Path directory;

  private static String on(String glass, String support) {
    return "<#%s> scene:state \"(on %s %s)\" , \"(in %s kitchen)\" .\n"
        .formatted(glass, glass, support, glass);
  }

  private String understood(String home, String... facts) throws IOException {
    Path scene = directory.resolve("world.ttl");
    Files.writeString(scene, HEAD + String.join("", facts));
    return Printed.by(
        "understand",
        SENTENCE,
        "--home",
        home,
        "--scene",
        scene.toString(),
        "--as",
        "Dave",
        "--in",
        "kitchen");
  }

  @Test
  void theOneOnTheFloorIsMeantWhereTheOtherIsOnTheTable() throws IOException {
    assertThat(understood("evening", on("glass-1", "table-1"), on("glass-2", "floor-k")))
        .contains("means  (initCNP (:goal (in glass-2 refrigerator)))");
  }

  @Test
  void ofTwoOnTheFloorItIsAskedWhich() throws IOException {
    assertThat(understood("evening", on("glass-1", "floor-k"), on("glass-2", "floor-k")))
        .contains("asks   Which glass do you mean?")
        .doesNotContain("means");
  }

  @Test
  void whereNoneIsOnTheFloorNothingIsGuessed() throws IOException {
    assertThat(understood("evening", on("glass-1", "table-1"), on("glass-2", "table-1")))
        .contains("asks   Which glass do you mean?")
        .doesNotContain("means");
  }

  @Test
  void whatIsInTheRefrigeratorAlreadyIsNotMeant() throws IOException {
    assertThat(
            understood(
                "evening",
                on("glass-1", "floor-k"),
                "<#glass-2> scene:state \"(in glass-2 refrigerator)\" .\n"))
        .contains("means  (initCNP (:goal (in glass-1 refrigerator)))");
  }

  @Test
  void whereNobodyKnowsWhereTheyAreItIsAsked() throws IOException {
    assertThat(understood("evening"))
        .contains("asks   Which glass do you mean?")
        .doesNotContain("means");
  }

  /** With one glass, and a refrigerator that has a floor of its own, the glass is put on that. */
  @Test
  void aRefrigeratorMayHaveAFloor() throws IOException {
    List<String> lines =
        Files.readAllLines(Path.of("../assembly/src/main/resources/homes/evening.ttl"));
    Path home = directory.resolve("home.ttl");
    Files.writeString(
        home,
        String.join("\n", lines.stream().filter(line -> !line.startsWith("home:glass-2 ")).toList())
            + "\n"
            + FLOOR_OF_THE_REFRIGERATOR);

    assertThat(understood(home.toString(), on("glass-1", "table-1")))
        .contains("means  (initCNP (:goal (on glass-1 floor-r)))");
  }
}
