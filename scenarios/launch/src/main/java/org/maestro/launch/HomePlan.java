package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Sentences;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.ontology.home.OpenChoice;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.PlanTime;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.cases.NotCarriedException;
import org.maestro.planning.export.PddlWriter;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/**
 * The platform's plan for a goal, made from a home file alone: nobody is asked for prices, and
 * nothing is known but what stands in the file.
 */
final class HomePlan {
  private static final int UNSOLVABLE = 10;
  private static final int NOTHING_FOUND = 12;

  private final PrintWriter out;
  private final boolean timed;

  /**
   * @param timed whether PDDL is to tell how long steps take
   */
  HomePlan(PrintWriter out, boolean timed) {
    this.out = out;
    this.timed = timed;
  }

  /**
   * The files into which a task was written as PDDL.
   *
   * @param notCarried sentences on what PDDL cannot say
   */
  record Written(Path domain, Path problem, List<String> notCarried) {}

  /**
   * Prints the plan.
   *
   * @param directory where to write the task as PDDL
   * @return the exit code
   */
  int show(String homeFile, String goalText, Optional<Path> directory, boolean json) {
    Home shipped = Shipped.home(homeFile);
    Formula goal = goal(shipped, goalText);
    Home home = NamedPoints.of(goal).in(shipped);
    PlanningTask task = task(home, goal);
    Optional<Written> written = directory.map(place -> write(task, place));
    PlanningResult result = asFarAsIsKnown(new OptimalPlanner().plan(task), home);
    Set<String> told =
        result instanceof PlanningResult.Impossible impossible
            ? told(home, impossible.explanation().obstacles())
            : Set.of();
    if (json) {
      out.println(
          new HomePlanDocument(
              homeFile,
              SlPrinter.print(goal),
              result,
              result instanceof PlanningResult.Found found && findsOut(found),
              List.copyOf(told),
              written));
    } else {
      written.ifPresent(this::tell);
      new HomePlanText(new Sentences(home.vocabulary()), out).print(result, told);
    }
    if (result instanceof PlanningResult.Found) {
      return ExitCode.DONE;
    }
    return result instanceof PlanningResult.Impossible && told.isEmpty()
        ? UNSOLVABLE
        : NOTHING_FOUND;
  }

  /** What is in no plan only because nobody says what may be chosen proves nothing. */
  private static PlanningResult asFarAsIsKnown(PlanningResult result, Home home) {
    List<OpenChoice> open = OpenChoice.of(home);
    return result instanceof PlanningResult.Impossible && !open.isEmpty()
        ? new PlanningResult.GaveUp(
            open.stream().map(OpenChoice::sentence).collect(Collectors.joining(" ")))
        : result;
  }

  private void tell(Written written) {
    out.printf("Written: %s and %s.%n", written.domain(), written.problem());
    written.notCarried().forEach(sentence -> out.println("  " + sentence));
  }

  static boolean findsOut(PlanningResult.Found found) {
    return found.plan().steps().stream().anyMatch(step -> PlanTime.senses(step.feature().effect()));
  }

  /** The words in what stands in the way that a platform would hear from its devices. */
  private static Set<String> told(Home home, List<PlanningResult.Obstacle> obstacles) {
    Set<String> words = new TreeSet<>();
    obstacles.stream()
        .filter(obstacle -> obstacle.subject().isEmpty())
        .map(obstacle -> SlParser.formula(obstacle.condition(), home.vocabulary()::isFluent))
        .forEach(
            condition ->
                Leaves.of(
                    condition,
                    atom -> words.add(atom.predicate()),
                    fluent -> words.add(fluent.name())));
    words.removeIf(word -> home.devices().values().stream().noneMatch(one -> one.tells(word)));
    return words;
  }

  private static Formula goal(Home home, String text) {
    Formula goal = SlParser.formula(text, home.vocabulary()::isFluent);
    try {
      new GoalCheck(home).check(goal);
    } catch (InvalidGoalException e) {
      throw CommandException.badInput(e);
    }
    return goal;
  }

  private static PlanningTask task(Home home, Formula goal) {
    List<PricedFeature> features = DescribedFeatures.of(home, device -> true);
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      return new PlanningTask(home.vocabulary(), knowledge.snapshot(), features, goal, Set.of());
    }
  }

  private Written write(PlanningTask task, Path directory) {
    try {
      PddlWriter.Texts texts =
          timed
              ? PddlWriter.writeTimed(task, "maestro-home")
              : PddlWriter.write(task, "maestro-home");
      Files.createDirectories(directory);
      Path domain = directory.resolve("domain.pddl");
      Path problem = directory.resolve("problem.pddl");
      Files.writeString(domain, texts.domain());
      Files.writeString(problem, texts.problem());
      return new Written(domain, problem, texts.notCarried());
    } catch (NotCarriedException e) {
      throw CommandException.badInput(e);
    } catch (IOException e) {
      throw CommandException.outside("Into %s nothing can be written.".formatted(directory), e);
    }
  }
}
