package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.bench.BenchReport;
import org.maestro.rats.conformance.DeviceRule;
import org.maestro.rats.conformance.Finding;
import picocli.CommandLine;

/**
 * What commands print with {@code --json} is as its schema says, and no member is left out of it.
 */
class JsonDocumentsTest {
  private static final String DOMAIN =
      """
      (define (domain tank) (:requirements :strips :numeric-fluents)
       (:predicates (ready) (full ?t)) (:functions (total-cost) (fuel))
       (:action fill :parameters (?t) :precondition (<= (fuel) 7)
         :effect (and (increase (fuel) 3) (full ?t) (increase (total-cost) 2.5)))
       (:action burn :precondition (>= (fuel) 5)
         :effect (and (decrease (fuel) 5) (ready) (increase (total-cost) 0.5))))
      """;
  private static final String PROBLEM =
      "(define (problem t) (:domain tank) (:objects red) (:init (= (fuel) 0)) (:goal (and (ready) GOAL)) (:metric minimize (total-cost)))";

  @TempDir private Path directory;

  private record Said(int exitCode, String out) {}

  private static Said said(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int exitCode =
        Maestro.commandLine(
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8))
            .execute(arguments);
    return new Said(exitCode, out.toString(StandardCharsets.UTF_8));
  }

  private static JsonNode document(String schema, int exitCode, String... arguments)
      throws IOException {
    Said said = said(arguments);
    assertThat(said.exitCode()).as(said.out()).isEqualTo(exitCode);
    return CommandSchemas.valid(schema, said.out());
  }

  @Test
  void everyCommandThatPrintsJsonHasItsSchemas() throws IOException {
    List<String> commands = new ArrayList<>();
    PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
    collect("", Maestro.commandLine(nowhere, nowhere), commands);

    TreeSet<String> described = new TreeSet<>();
    for (String name : CommandSchemas.names()) {
      commands.stream()
          .filter(command -> name.equals(command) || name.startsWith(command + "-"))
          .forEach(described::add);
    }
    assertThat(commands).contains("agents", "plan", "device-test");
    assertThat(described).containsExactlyInAnyOrderElementsOf(commands);
  }

  private static void collect(String path, CommandLine command, List<String> commands) {
    if (command.getCommandSpec().findOption("--json") != null) {
      commands.add(path);
    }
    command
        .getSubcommands()
        .forEach((name, sub) -> collect(path.isEmpty() ? name : path + "-" + name, sub, commands));
  }

  @Test
  void everySchemaIsClosedAndSaysWhatEachMemberIs() throws IOException {
    for (String name : CommandSchemas.names()) {
      JsonNode schema = CommandSchemas.schema(name);
      assertThat(schema.path("$id").asText())
          .isEqualTo("https://w3id.org/maestro/commands/" + name + ".json");
      assertThat(schema.path("title").asText()).startsWith("./maestro ").contains(" --json");
      assertClosed(name, schema);
    }
  }

  private static void assertClosed(String where, JsonNode schema) {
    JsonNode properties = schema.path("properties");
    if (properties.isObject()) {
      assertThat(schema.path("additionalProperties").isBoolean()).as(where).isTrue();
      assertThat(schema.path("additionalProperties").asBoolean()).as(where).isFalse();
      List<String> required = new ArrayList<>();
      schema.path("required").forEach(member -> required.add(member.asText()));
      List<String> members = new ArrayList<>();
      properties.fieldNames().forEachRemaining(members::add);
      assertThat(required).as(where).containsExactlyInAnyOrderElementsOf(members);
      for (String member : members) {
        String inside = where + "." + member;
        assertThat(properties.at("/" + member + "/description").asText()).as(inside).isNotBlank();
        assertClosed(inside, properties.path(member));
      }
    }
    if (schema.has("items")) {
      assertClosed(where + "[]", schema.path("items"));
    }
  }

  @Test
  void wordsHaveTheirPartsApart() throws IOException {
    JsonNode words = document("words", 0, "words", "bob", "--json").path("words");
    JsonNode illuminance = named(words, "illuminance");
    assertThat(illuminance.path("unit").asText()).isEqualTo("lux");
    assertThat(illuminance.at("/arguments/0/variable").asText()).isEqualTo("z");
    assertThat(illuminance.at("/arguments/0/class").asText()).isEqualTo("Location");
    assertThat(named(words, "pick").at("/devices/0").asText()).isEqualTo("rose");
    assertThat(named(words, "Cup").path("arguments")).isEmpty();
    assertThat(named(words, "inside").path("arguments").findValuesAsText("class"))
        .containsExactly("null", "Location");
  }

  private static JsonNode named(JsonNode words, String word) {
    for (JsonNode entry : words) {
      if (entry.path("word").asText().equals(word)) {
        return entry;
      }
    }
    throw new AssertionError("There is no word " + word + " in " + words);
  }

  @Test
  void aCheckTellsFaultsAndWhoCouldJoin() throws IOException {
    assertThat(document("check", 0, "check", "bob", "--json").path("faults")).isEmpty();
    Path bell = directory.resolve("bell.json");
    String right =
        """
        {"@context": ["https://w3id.org/maestro/context.jsonld", {"b": "https://example.org/bells#"}],
         "id": "b:bell-1", "type": "maestro:Device",
         "offers": {"id": "b:ring", "type": "maestro:Task",
           "input": {"name": "who", "types": ["domain:Person"]}, "effect": "(called ?who)", "cost": "1"},
         "brings": {"id": "b:called", "type": "maestro:Predicate", "arguments": ["?p - Person"]}}
        """;
    Files.writeString(bell, right);
    JsonNode joining = document("check", 0, "check", bell.toString(), "--json").path("could_join");
    assertThat(joining.at("/0/device").asText()).isEqualTo("bell-1");
    assertThat(joining.at("/0/features/0").asText()).isEqualTo("ring");
    Files.writeString(bell, right.replace("(called ?who)", "(calld ?who)"));
    JsonNode faults = document("check", 1, "check", bell.toString(), "--json").path("faults");
    assertThat(faults.at("/0/cure").asText()).contains("called");
    assertThat(faults.at("/0/line").asInt()).isEqualTo(4);
  }

  @Test
  void aHomesPlanTellsWhoDoesWhatWhenAndAtWhichCost() throws IOException {
    JsonNode plan = document("plan-home", 0, "plan", "bob", "(nextTo Cup Bob)", "--json");
    assertThat(plan.path("verdict").asText()).isEqualTo("plan");
    assertThat(plan.path("proven").asBoolean()).isFalse();
    double cost = 0;
    double end = 0;
    for (JsonNode step : plan.path("steps")) {
      cost += step.path("cost").asDouble();
      double begin = step.path("start_s").asDouble();
      step.path("after")
          .forEach(
              before -> {
                JsonNode first = plan.path("steps").get(before.asInt() - 1);
                assertThat(first.path("start_s").asDouble() + first.path("duration_s").asDouble())
                    .isLessThanOrEqualTo(begin);
              });
      end = Math.max(end, begin + step.path("duration_s").asDouble());
    }
    assertThat(plan.path("cost").asDouble()).isEqualTo(cost);
    assertThat(plan.path("duration_s").asDouble()).isEqualTo(end);
    JsonNode place = plan.path("steps").get(plan.path("steps").size() - 1);
    assertThat(place.path("agent").asText()).isEqualTo("rose");
    assertThat(place.path("feature").asText()).isEqualTo("place");
    assertThat(place.at("/bindings/target").asText()).isEqualTo("Bob");
    assertThat(plan.path("searches").findValuesAsText("predicate")).contains("in");

    JsonNode known = document("plan-home", 0, "plan", "flat", "(open bedroom-door)", "--json");
    assertThat(known.path("proven").asBoolean()).isTrue();
    assertThat(known.path("lower_bound").asDouble()).isEqualTo(known.path("cost").asDouble());
  }

  @Test
  void aHomesGoalWithoutAPlanIsExplained() throws IOException {
    JsonNode proven = document("plan-home", 10, "plan", "bob", "(senses lux-a zone-b)", "--json");
    assertThat(proven.path("verdict").asText()).isEqualTo("unsolvable");
    assertThat(proven.path("proven").asBoolean()).isTrue();
    assertThat(proven.path("cost").isNull()).isTrue();
    assertThat(proven.at("/obstacles/0/condition").asText()).isEqualTo("(senses lux-a zone-b)");

    JsonNode open = document("plan-home", 12, "plan", "bob", "(= (level lamp-a1) 1)", "--json");
    assertThat(open.path("verdict").asText()).isEqualTo("none found");
    assertThat(open.at("/told_by_devices/0").asText()).isEqualTo("level");
  }

  @Test
  void whereAHomesTaskWasWrittenStandsInTheDocument() throws IOException {
    JsonNode plan =
        document(
            "plan-home",
            0,
            "plan",
            "bob",
            "(nextTo Cup Bob)",
            "--json",
            "--pddl",
            directory.toString());
    assertThat(Path.of(plan.at("/written/domain").asText())).isRegularFile();
  }

  @ParameterizedTest
  @CsvSource({"(full red), 0, plan", "(> (fuel) 10), 10, unsolvable"})
  void aProblemsPlanHasItsActionsApart(String goal, int exitCode, String verdict)
      throws IOException {
    Path domain = Files.writeString(directory.resolve("d.pddl"), DOMAIN);
    Path problem = Files.writeString(directory.resolve("p.pddl"), PROBLEM.replace("GOAL", goal));
    JsonNode plan =
        document("plan-pddl", exitCode, "plan", domain.toString(), problem.toString(), "--json");
    assertThat(plan.path("verdict").asText()).isEqualTo(verdict);
    assertThat(plan.path("proven").asBoolean()).isTrue();
    if (exitCode == 0) {
      assertThat(plan.path("cost").asDouble()).isEqualTo(5.5);
      assertThat(plan.at("/steps/0/action").asText()).isEqualTo("fill");
      assertThat(plan.at("/steps/0/arguments/0").asText()).isEqualTo("red");
      assertThat(plan.at("/steps/0/cost").asDouble()).isEqualTo(2.5);
    } else {
      assertThat(plan.at("/reasons/0").asText()).contains("(> (fuel) 10)");
    }
  }

  @Test
  void anExperimentTellsItsFigures() throws IOException {
    JsonNode findings =
        document(
            "experiment",
            0,
            "experiment",
            "broken-cup",
            "--runs",
            "1",
            "--json",
            "--out",
            directory.toString());
    assertThat(Path.of(findings.path("page").asText())).isRegularFile();
    assertThat(findings.at("/results/0/value").isNumber()).isTrue();
    assertThat(findings.at("/results/0/unit").isNull()).isTrue();
  }

  @Test
  void whatABenchmarkCouldNotMeasureIsNull() throws IOException {
    BenchReport report =
        new BenchReport(
            "bus",
            BenchReport.thisMachine(),
            List.of(
                BenchReport.Row.of("messages", 3, ""),
                BenchReport.Row.of("mean of none", Double.NaN, "ms"),
                new BenchReport.Row("time", 3, "s", OptionalDouble.of(2))),
            List.of("A line."));
    JsonNode rows = CommandSchemas.valid("bench", report.json()).path("rows");
    assertThat(rows.at("/1/value").isNull()).isTrue();
    assertThat(rows.at("/2/ratio").asDouble()).isEqualTo(1.5);
  }

  @Test
  void theFindingsOnADeviceAreARowForEachRule() throws IOException {
    List<Finding> findings = new ArrayList<>();
    for (DeviceRule rule : DeviceRule.values()) {
      for (Finding.Verdict verdict : Finding.Verdict.values()) {
        findings.add(new Finding(rule, verdict, verdict == Finding.Verdict.KEPT ? "" : "Seen."));
      }
    }
    assertThat(
            CommandSchemas.valid("device-test", DeviceTestCommand.document("kettle-1", findings))
                .path("findings"))
        .hasSameSizeAs(findings);
  }

  @Test
  void aCalibrationSaysInWhichLightPicturesShowAThing() throws IOException {
    JsonNode document =
        document(
            "calibrate-camera",
            ExitCode.DONE,
            "calibrate camera arena --camera cam-2 --thing GreenObject --places 1 --json"
                .split(" "));

    assertThat(document.path("settings").path("world.camera.halfLux").asDouble()).isPositive();
    assertThat(document.path("dark").get(0).path("shown").asInt()).isZero();
  }
}
