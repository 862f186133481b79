package org.maestro.planning.pddl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

class PddlReaderTest {
  private static final String DOMAIN =
      """
      (define (domain lamps)
        (:requirements :strips :typing :negative-preconditions :equality :fluents
          :existential-preconditions)
        (:types lamp room)
        (:predicates (on ?l - lamp) (in ?l - lamp ?r - room) (seen ?r - room) (other ?r ?s - room))
        (:functions (total-cost) - number (lux ?r - room) (gain ?l - lamp))
        (:action switch-on
          :parameters (?l - lamp ?r - room)
          :precondition (and (in ?l ?r) (not (on ?l)))
          :effect (and (on ?l) (increase (lux ?r) (gain ?l)) (increase (total-cost) 2.5)))
        (:action look
          :parameters (?r - room)
          :precondition (and (>= (lux ?r) 72) (<= (lux ?r) 80) (exists (?l - lamp) (in ?l ?r)))
          :effect (and (seen ?r) (increase (total-cost) 1)))
        (:action compare
          :parameters (?r ?s - room)
          :precondition (and (not (= ?r ?s)) (seen ?r))
          :effect (other ?r ?s)))
      """;
  private static final String PROBLEM =
      """
      (define (problem p) (:domain lamps)
        (:objects a b c - lamp r s - room)
        (:init (in a r) (in b r) (in c r) (= (total-cost) 0) (= (lux r) 1.5) (= (lux s) 0)
          (= (gain a) 40) (= (gain b) 45.25) (= (gain c) 35))
        (:goal (exists (?x - room) (other r ?x)))
        (:metric minimize (total-cost)))
      """;

  @Test
  void readsNumbersNegationEqualityAndExistence() {
    List<String> plan = plan(DOMAIN, PROBLEM, "6");
    assertThat(plan)
        .containsExactlyInAnyOrder(
            "(switch-on a r)", "(switch-on c r)", "(look r)", "(compare r s)");
    assertThat(plan).endsWith("(compare r s)");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        ":equality | :derived-predicates | :derived-predicates",
        "(not (on ?l))) | (imply (on ?l))) | (imply",
        "(not (on ?l))) | (preference (on ?l))) | (preference",
        "(not (on ?l))) | (not (exists (?m - lamp) (om ?m)))) | om ?m",
        "(and (on ?l) | (and (when (on ?l) (when (on ?l) (seen ?r))) | (when (on ?l) (seen",
        "(and (on ?l) | (and (when (on ?l)) | (when",
        "(and (on ?l) | (and (forall (?x - lam) (on ?x)) | ?x - lam",
        "(increase (total-cost) 1) | (assign (total-cost) 1) | (assign",
        "(seen ?r)) | (sen ?r)) | sen ",
        "?l - lamp ?r - room) | ?l - lamp ?r - hall) | ?r - hall",
        "(on ?l) (increase | (on ?m) (increase | ?m) (increase"
      })
  void namesWhatItDoesNotUnderstandWithLineAndColumn(String from, String to, String named) {
    int at = DOMAIN.lastIndexOf(from);
    String domain = DOMAIN.substring(0, at) + to + DOMAIN.substring(at + from.length());
    String before = domain.substring(0, domain.indexOf(named));
    long line = before.chars().filter(c -> c == '\n').count() + 1;
    int column = before.length() - before.lastIndexOf('\n');
    assertThatThrownBy(() -> PddlReader.parse("d", domain, "p", PROBLEM))
        .isInstanceOf(PddlException.class)
        .hasMessageStartingWith("d:%d:%d: ".formatted(line, column));
  }

  @Test
  void namesAnObjectThatIsMissing() {
    assertThatThrownBy(
            () -> PddlReader.parse("d", DOMAIN, "p", PROBLEM.replace("(in c r)", "(in z r)")))
        .hasMessage("p:3:32: There is no object z; declare it in (:objects ...).");
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN, "p", PROBLEM.replace("(:goal", "(:g")))
        .hasMessageStartingWith("p:5:3: (:g ...) is not supported.");
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN, "p", PROBLEM.replace("(:goal", "(:g%d")))
        .hasMessageStartingWith("p:5:3: (:g%d ...) is not supported.");
    String twice = PROBLEM.replace("(= (lux s) 0)", "(= (lux s) 0) (= (lux s) 0.0) (= (lux s) 1)");
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN, "p", twice))
        .hasMessage("p:3:102: This function has the value 0.0 already.");
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN.substring(0, 300), "p", PROBLEM))
        .hasMessageContaining("is never closed");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(in a r) | (in r a) | p:3:14: in takes an object of the type lamp here, and r is none.",
        "(= (lux s) 0) | (= (lux b) 0) | p:3:80: lux takes an object of the type room here, and b"
            + " is none.",
        "(other r ?x) | (other c ?x) | p:5:37: other takes an object of the type room here, and c"
            + " is none.",
        "(:domain lamps) | '' | p:1:1: The problem does not name its (:domain lamps).",
        "(:domain lamps) | (:domain lights) | p:1:30: The problem is of the domain lights, not of"
            + " lamps."
      })
  void refusesWhatIsSaidOfTheWrongThings(String from, String to, String refusal) {
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN, "p", PROBLEM.replace(from, to)))
        .isInstanceOf(PddlException.class)
        .hasMessage(refusal);
  }

  @Test
  void namesTheActionThatGroundingRefuses() {
    String dear = DOMAIN.replace("(total-cost) 2.5", "(total-cost) (- 1 (gain ?l))");
    assertThatThrownBy(() -> plan(dear, PROBLEM, "6"))
        .hasMessage("d:7:12: switch-on costs -39; costs below 0 are not supported.");
    String twice = DOMAIN.replace("(<= (lux ?r) 80)", "(<= (* (lux ?r) (lux ?r)) 80)");
    assertThatThrownBy(() -> plan(twice, PROBLEM, "6"))
        .hasMessage("d:11:12: A product of two numbers that change is not supported.");
  }

  @Test
  void refusesTwoOfOneName() {
    String action = "(:action again :parameters (%s) :effect (seen r))";
    int end = DOMAIN.lastIndexOf(')');
    String twice = DOMAIN.substring(0, end) + action.formatted("") + action.formatted("") + ")";
    assertThatThrownBy(() -> PddlReader.parse("d", twice, "p", PROBLEM))
        .hasMessageEndingWith("The action again is there twice.");
    assertThatThrownBy(
            () ->
                PddlReader.parse(
                    "d", DOMAIN, "p", PROBLEM.replace("(:goal", "(:goal (and)) (:goal")))
        .hasMessage("p:5:17: (:goal ...) is there twice.");
    String same = DOMAIN.substring(0, end) + action.formatted("?a ?a - room") + ")";
    assertThatThrownBy(() -> PddlReader.parse("d", same, "p", PROBLEM))
        .hasMessageEndingWith("Two parameters have the same name.");
  }

  @Test
  void readsCompressedFiles(@TempDir Path folder) throws IOException {
    Path domain = folder.resolve("d.pddl");
    Path problem = folder.resolve("p.pddl.gz");
    Files.writeString(domain, DOMAIN);
    try (GZIPOutputStream out = new GZIPOutputStream(Files.newOutputStream(problem))) {
      out.write(PROBLEM.getBytes());
    }
    assertThat(PddlReader.read(domain, problem).objects()).hasSize(5);
  }

  @Test
  void saysWhichFileCannotBeRead(@TempDir Path folder) throws IOException {
    Path domain = folder.resolve("d.pddl");
    Files.writeString(domain, DOMAIN);
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
      out.write(PROBLEM.getBytes());
    }
    byte[] whole = packed.toByteArray();
    for (int length : new int[] {2, 9, 20, whole.length - 4}) {
      Path cut = Files.write(folder.resolve("p.gz"), Arrays.copyOf(whole, length));
      assertThatThrownBy(() -> PddlReader.read(domain, cut))
          .isInstanceOf(IOException.class)
          .hasMessage(
              cut + " begins as a gzip file, but cannot be unpacked: it is cut off or broken.");
    }
    assertThatThrownBy(() -> PddlReader.read(domain, folder))
        .isInstanceOf(IOException.class)
        .hasMessage(folder + " is a directory; name a PDDL file in it.");
  }

  @ParameterizedTest
  @CsvSource({
    "home-domain, paper-next, 21",
    "home-domain, paper-see-other-room, 21",
    "home-domain, home-0010-next2-s1, 65",
    "battery-domain, batt-0010-next2-s1, 32"
  })
  void provesTheCheapestPlanOfHomes(String domain, String problem, String cost) throws IOException {
    String domainText = resource(domain);
    String problemText = resource(problem);
    plan(domainText, problemText, cost);
    // The order of facts plays no part, costs times 7 make plans cost 7 times as much.
    String shuffled = problemText.replaceAll("(?s)\\(:init(.*?)\\n    \\(at", "(:init\n    (at");
    plan(domainText, shuffled, cost);
    plan(
        domainText,
        problemText.replaceAll("\\(= (\\(\\S+-cost [^)]*\\)) (\\d+)\\)", "(= $1 $20)"),
        cost + "0");
  }

  @Test
  void provesThatThereIsNoPlan() throws IOException {
    GroundTask task = ground(resource("home-domain"), resource("home-0010-nolight-s1"));
    assertThat(solve(task).verdict()).isEqualTo(Solution.Verdict.UNSOLVABLE);
  }

  @Test
  void takesACheaperDeviceAndNoUselessOne() throws IOException {
    String domain = resource("home-domain");
    String problem = resource("paper-next");
    String useless =
        problem
            .replace("camera1 camera2", "camera0 camera1 camera2")
            .replace("(:init", "(:init (online camera0) (= (observe-cost camera0) 1)");
    plan(domain, useless, "21");
    plan(
        domain,
        problem.replace("(= (observe-cost camera1) 2)", "(= (observe-cost camera1) 1)"),
        "20");
    Solution without = solve(ground(domain, problem.replace("(online camera1)", "")));
    assertThat(without.cost()).isGreaterThanOrEqualTo(21);
  }

  private static List<String> plan(String domain, String problem, String cost) {
    GroundTask task = ground(domain, problem);
    Solution solution = solve(task);
    assertThat(solution.verdict()).isEqualTo(Solution.Verdict.OPTIMAL);
    List<String> plan = solution.operators().stream().map(task.names()::operator).toList();
    List<String> steps = plan.stream().filter(step -> !step.isEmpty()).toList();
    assertThat(new PlanExecutor(domain, problem).cost(steps)).isEqualByComparingTo(cost);
    assertThat(task.unit().multiply(new java.math.BigDecimal(cost)))
        .isEqualByComparingTo(java.math.BigDecimal.valueOf(solution.cost()));
    return steps;
  }

  private static GroundTask ground(String domain, String problem) {
    return Grounder.ground(PddlReader.parse("d", domain, "p", problem), GroundingBudget.endless());
  }

  private static Solution solve(GroundTask task) {
    return new AnytimePlanner(task, 200_000_000, line -> {}).solve(GroundingBudget.endless());
  }

  private static String resource(String name) throws IOException {
    try (var in = PddlReaderTest.class.getResourceAsStream(name + ".pddl")) {
      return new String(in.readAllBytes());
    }
  }
}
