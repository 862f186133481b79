package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectReader;
import com.networknt.schema.serialization.YamlMapperFactory;
import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToLongFunction;
import org.junit.jupiter.api.Test;
import org.maestro.launch.Printed;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** The page of wanted scripts shows what the home has, and counts what it shows. */
class ScriptsPageTest {
  private static final Path HOME = Path.of("../assembly/src/main/resources/homes/household.ttl");
  private static final ObjectReader YAML =
      YamlMapperFactory.getInstance().reader(DeserializationFeature.FAIL_ON_READING_DUP_TREE_KEY);

  private final List<WantedScript> scripts = WantedScript.all();

  @Test
  void theTenAreThoseOfTheHomeInItsOrder() throws IOException {
    String home = Files.readString(HOME);

    assertThat(home)
        .contains(WantedScript.block(WantedScript.page(), "turtle").split("\n(?=home:)"));
    assertThat(home.substring(home.indexOf("# --- Scripts\n")))
        .isEqualTo(
            "# --- Scripts\n\n"
                + String.join("\n", scripts.stream().map(WantedScript::turtle).toList()));
    assertThat(scripts).hasSize(10);
    assertThat(Printed.by("scripts", HOME.toString()).lines())
        .filteredOn(line -> line.startsWith("("))
        .hasSize(10);
  }

  @Test
  void eachIsRunByATest() {
    assertThat(ScriptsPeopleWantTest.class.getDeclaredMethods())
        .filteredOn(method -> method.isAnnotationPresent(Test.class))
        .extracting(Method::getName)
        .containsAll(scripts.stream().map(WantedScript::name).toList());
  }

  @Test
  void theCommandsAskForThem() {
    Home home = new HomeLoader().load(HOME);
    assertThat(scripts)
        .allSatisfy(
            script ->
                assertThat(SlParser.formula(script.goal(), home.vocabulary()::isFluent).toString())
                    .contains(script.name()));
  }

  /** With the words of now, and each key once; whether the calls are right, nobody here can say. */
  @Test
  void theOthersAreYamlOfItsShape() {
    assertThat(scripts)
        .allSatisfy(
            script -> {
              JsonNode root = YAML.readTree(script.yaml());
              assertThat(root).hasSize(1);
              if (root.has("script")) {
                assertThat(root.get("script")).hasSize(1);
                assertThat(root.get("script").elements().next().get("sequence").isArray()).isTrue();
              } else {
                JsonNode automation = root.path("automation").path(0);
                assertThat(automation.path("triggers").findValuesAsText("trigger")).isNotEmpty();
                assertThat(automation.path("actions").findValuesAsText("action"))
                    .isNotEmpty()
                    .allMatch(action -> action.matches("[a-z_]+\\.[a-z_]+"));
              }
            });
  }

  @Test
  void theTableCountsTheLinesOfThePage() {
    assertThat(scripts)
        .allSatisfy(
            script ->
                assertThat(WantedScript.page())
                    .contains(
                        "\n| `%s` | %d | %d | "
                            .formatted(
                                script.name(), script.lines(), WantedScript.lines(script.yaml()))));
    assertThat(WantedScript.page())
        .contains(
            "\n| all ten | %d | %d | "
                .formatted(
                    sum(WantedScript::lines), sum(script -> WantedScript.lines(script.yaml()))))
        .contains(
            "The four words above, %d lines,"
                .formatted(WantedScript.lines(WantedScript.block(WantedScript.page(), "turtle"))))
        .contains(
            "without blanks, ours have %d and theirs %d"
                .formatted(
                    sum(WantedScript::characters),
                    sum(script -> WantedScript.characters(script.yaml()))));
  }

  private long sum(ToLongFunction<WantedScript> count) {
    return scripts.stream().mapToLong(count).sum();
  }
}
