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
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The planner alone, as people call it. */
class PlanCommandTest {
  private static final String DOMAIN =
      """
      (DEFINE (DOMAIN tank) (:REQUIREMENTS :STRIPS :NUMERIC-FLUENTS)
       (:PREDICATES (ready)) (:FUNCTIONS (total-cost) (fuel))
       (:ACTION fill :PARAMETERS () :PRECONDITION (<= (fuel) 7)
         :EFFECT (AND (INCREASE (fuel) 3) (INCREASE (total-cost) 2)))
       (:ACTION burn :PRECONDITION (>= (fuel) 5)
         :EFFECT (AND (DECREASE (fuel) 5) (ready) (INCREASE (total-cost) 0.5))))
      """;
  private static final String PROBLEM =
      "(define (problem t) (:domain tank) (:init (= (fuel) 0)) (:goal (and (ready) GOAL)) (:metric minimize (total-cost)))";

  /** It goes ten degrees up or down in a second. */
  private static final String KILN =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/pottery#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .

      <https://w3id.org/maestro/home/pottery> a maestro:Home ; rdfs:label "the pottery"@en .
      home:Vessel a owl:Class ; rdfs:subClassOf maestro:Thing .
      home:Kiln a owl:Class ; rdfs:subClassOf maestro:Device ; maestro:offers home:heat , home:fire .
      home:warmth a maestro:Fluent ; maestro:arguments ( "?k - Kiln" ) .
      home:fired a maestro:Predicate ; maestro:arguments ( "?v - Vessel" ) .
      home:heat a maestro:Task ; maestro:sentence "{self} goes to {degrees} degrees" ;
        maestro:input [ maestro:name "degrees" ; maestro:type xsd:decimal ; maestro:oneOf ( 400 900 ) ] ;
        maestro:effect "(assign (warmth ?self) ?degrees)" ; maestro:cost "1" ;
        maestro:seconds "(/ (- ?degrees (warmth ?self)) 10)" ; maestro:occupies ( "coil" ) .
      home:fire a maestro:Task ; maestro:sentence "{self} fires {vessel}" ;
        maestro:input [ maestro:name "vessel" ; maestro:type home:Vessel ] ;
        maestro:precondition "(>= (warmth ?self) 900)" ; maestro:effect "(fired ?vessel)" ;
        maestro:cost "5" ; maestro:seconds "30" ; maestro:occupies ( "chamber" ) .
      home:kiln-1 a home:Kiln ; home:warmth 20 .
      home:jug a home:Vessel .
      home:bowl a home:Vessel .
      """;

  @TempDir Path directory;

  private record Said(int exitCode, String out, String err) {}

  @Test
  void writesAHomesTaskThatCostsTheSame() {
    Path pddl = directory.resolve("bob");
    Said home = maestro("plan", "bob", "(nextTo Cup Bob)", "--pddl", pddl.toString());
    assertThat(home.exitCode()).isZero();
    Said written =
        maestro(
            "plan",
            pddl.resolve("domain.pddl").toString(),
            pddl.resolve("problem.pddl").toString());
    assertThat(written.exitCode()).isZero();
    assertThat(last(written.out())).startsWith("; cost = ").endsWith("(optimal)");
    assertThat(last(home.out()))
        .isEqualTo(last(written.out()).replace("(optimal)", "(if what is found out is as hoped)"));
  }

  @Test
  void writesProcessesThatTakeAsLongAsTheyDoHere() throws IOException {
    Path home = Files.writeString(directory.resolve("kiln.ttl"), KILN);
    Path pddl = directory.resolve("plus");

    Said said = maestro("plan", home.toString(), "(fired jug)", "--pddl-plus", pddl.toString());

    assertThat(said.exitCode()).as(said.err()).isZero();
    assertThat(said.out()).contains("What has to hold while a step goes on is asked only");
    String domain = Files.readString(pddl.resolve("domain.pddl"));
    String fromCold = "(value-of-warmth kiln-1 n20) (not (running-heat__kiln-1__900))";
    assertThat(domain)
        .contains(":time")
        .contains(
            fromCold
                + " (not (busy-kiln-1-coil)))\n    :effect (and (running-heat__kiln-1__900)"
                + " (busy-kiln-1-coil) (assign (clock-heat__kiln-1__900) 0)"
                + " (increase (total-cost) 1)))")
        .contains("(increase (clock-heat__kiln-1__900) (* #t 1))")
        .contains("(and (running-heat__kiln-1__900) (>= (clock-heat__kiln-1__900) 88))")
        .contains("(and (not (running-fire__kiln-1__jug)) (not (busy-kiln-1-chamber)) (fired jug))")
        .contains("(>= (clock-fire__kiln-1__jug) 30)");
    assertThat(Files.readString(pddl.resolve("problem.pddl")))
        .contains("(= (clock-fire__kiln-1__jug) 0)")
        .contains("(:goal (and (fired jug)))");
  }

  @Test
  void saysWhenAnotherPlannerCannotBeToldHowLongSomethingTakes() throws IOException {
    Path home =
        Files.writeString(
            directory.resolve("kiln.ttl"),
            KILN.replace("(assign (warmth ?self) ?degrees)", "(increase (warmth ?self) ?degrees)"));

    Said said =
        maestro(
            "plan",
            home.toString(),
            "(fired jug)",
            "--pddl-plus",
            directory.resolve("plus").toString());

    assertThat(said.exitCode()).isEqualTo(2);
    assertThat(said.err())
        .contains("PDDL cannot carry how long heat of kiln-1 takes: it depends on (warmth kiln-1)");
  }

  @Test
  void saysHowSurelyWhatIsSoughtIsWhereItLooksFirst() {
    Said said = maestro("plan", "arena", "(canSee ?agent RedObject1)");
    assertThat(said.exitCode()).isZero();
    assertThat(said.out())
        .contains("; RedObject1 is in zone-1: 33 %; to look there first is expected to cost 3 in")
        .contains(" in all, in zone-2 3, in zone-3 3")
        .doesNotContain("optimal");
  }

  @Test
  void callsOnlyThatOptimalForWhichNothingHasToBeFoundOut() {
    Said hopes = maestro("plan", "bob", "(>= (illuminance zone-a) 99999)");
    assertThat(hopes.exitCode()).isZero();
    assertThat(last(hopes.out())).isEqualTo("; cost = 0.5 (if what is found out is as hoped)");
    Said knows = maestro("plan", "flat", "(open bedroom-door)");
    assertThat(knows.exitCode()).isZero();
    assertThat(last(knows.out())).endsWith(" (optimal)");
  }

  @ParameterizedTest
  @ValueSource(strings = {"--first", "--verbose", "--deadline=3"})
  void refusesForAHomeWhatGoesWithAProblem(String option) {
    Said said = maestro("plan", "bob", "(nextTo Cup Bob)", option);
    assertThat(said.exitCode()).isEqualTo(2);
    assertThat(said.err()).contains("go with a problem in PDDL");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(<= (fuel) 1) | 0 | ; cost = 4.5 (optimal)",
        "(= (fuel) 2) | 0 | ; cost = 9 (optimal)",
        "(> (fuel) 10) | 10 | ; needed: (> (fuel) 10); no order of steps brings it about"
      })
  void solvesNumbersInCapitalsWithAnyLineEnds(String goal, int exitCode, String end)
      throws IOException {
    Said said = solve(DOMAIN.replace("\n", "\r\n"), PROBLEM.replace("GOAL", goal));
    assertThat(said.exitCode()).isEqualTo(exitCode);
    assertThat(last(said.out())).isEqualTo(end);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(ready | (set | d.pddl:6:38: There is no predicate set.",
        "(ready) (INC | (or (ready) (ready)) (INC | d.pddl:6:37: (or ...) in an effect is not supported.",
        ":STRIPS | :PREFERENCES | d.pddl:1:38: The requirement :preferences is not supported."
      })
  void namesWhatIsNotUnderstood(String from, String to, String problem) throws IOException {
    int at = DOMAIN.lastIndexOf(from);
    Said said =
        solve(
            DOMAIN.substring(0, at) + to + DOMAIN.substring(at + from.length()),
            PROBLEM.replace("GOAL", ""));
    assertThat(said.exitCode()).isEqualTo(2);
    assertThat(said.err()).contains(problem).doesNotContain("\tat ");
    assertThat(said.out()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "bob | (nextTo Cup Bobb) | Nobody knows a thing named Bobb",
        "bob | (nexTo Cup Bob) | nexTo",
        "bob | (nextTo Cup | was expected",
        "nowhere.ttl | (nextTo Cup Bob) | There is no home file nowhere.ttl",
        "livingroom | (activateTV bedroom) | activateTV is a script, whose plans are made as it goes on",
        "bob | (after 5 (nextTo Cup Bob)) | has no plan before it begins"
      })
  void refusesGoalsThatMeanNothing(String home, String goal, String sentence) {
    Said said = maestro("plan", home, goal);
    assertThat(said.exitCode()).isEqualTo(2);
    assertThat(said.err()).contains(sentence).doesNotContain("\tat ");
  }

  @Test
  void saysWhyAHomeHasNoPlan() {
    Said said = maestro("plan", "bob", "(senses lux-a zone-b)");
    assertThat(said.exitCode()).isEqualTo(10);
    assertThat(said.out()).startsWith("; unsolvable (proven)").contains("needed");
  }

  /** A lamp's level is set by what it was, which only the lamp knows. */
  @Test
  void callsNothingUnsolvableForWantOfWhatDevicesTell() {
    Said said = maestro("plan", "bob", "(= (level lamp-a1) 1)");
    assertThat(said.exitCode()).isEqualTo(12);
    assertThat(said.out())
        .startsWith("; no plan from the file alone: the devices themselves tell level")
        .contains("needed");
  }

  @Test
  void saysSoWhenMemoryIsUsedUpBeforeAnythingIsFound() throws IOException, InterruptedException {
    String words = IntStream.range(0, 60).mapToObj(i -> "o" + i).collect(Collectors.joining(" "));
    Path domain =
        Files.writeString(
            directory.resolve("d.pddl"),
            """
            (define (domain large) (:predicates (p ?a ?b ?c ?d) (won))
             (:action make :parameters (?a ?b ?c ?d) :effect (p ?a ?b ?c ?d))
             (:action win :parameters (?a ?b ?c ?d) :precondition (p ?a ?b ?c ?d) :effect (won)))
            """);
    Path problem =
        Files.writeString(
            directory.resolve("p.pddl"),
            "(define (problem l) (:domain large) (:objects %s) (:init) (:goal (won)))"
                .formatted(words));
    JavaProcess.Ended ended =
        JavaProcess.start(
                PlanProgram.class.getName(),
                List.of(domain.toString(), problem.toString()),
                Map.of("JAVA_TOOL_OPTIONS", "-Xmx32m"))
            .await(Duration.ofSeconds(60));
    assertThat(ended.exitCode()).isEqualTo(12);
    assertThat(ended.output()).contains("the memory is used up; give Java more");
    assertThat(ended.errors()).doesNotContain("\tat ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "d.pddl p.pddl | true",
        "--first d.pddl --deadline 5 p.pddl | true",
        "d.pddl p.pddl --deadline=5 | false",
        "d.pddl p.pddl --deadline -5 | false",
        "d.pddl p.pddl --deadline soon | false",
        "d.pddl p.pddl --deadline | false",
        "d.pddl | false",
        "d.pddl p.pddl q.pddl | false",
        "bob (in | false",
        "--help | false"
      })
  void whatMostWriteNeedsNoLibraryToBeRead(String arguments, boolean plain) {
    assertThat(PddlSolving.Asked.plain(arguments.split(" ")).isPresent()).isEqualTo(plain);
  }

  private Said solve(String domain, String problem) throws IOException {
    Path d = Files.writeString(directory.resolve("d.pddl"), domain);
    Path p = Files.writeString(directory.resolve("p.pddl"), problem);
    return maestro("plan", d.toString(), p.toString(), "--deadline", "60");
  }

  private static String last(String text) {
    return text.strip().lines().reduce("", (before, line) -> line);
  }

  private static Said maestro(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int exitCode =
        Maestro.commandLine(new PrintStream(out), new PrintStream(err)).execute(arguments);
    return new Said(
        exitCode, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
  }
}
