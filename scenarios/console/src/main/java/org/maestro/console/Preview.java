package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collection;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.maestro.console.documents.PreviewDocument;
import org.maestro.console.questions.RefusalException;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.PlanningTask;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * The plan for a goal before anybody is asked for anything: from what is known now, with those who
 * are there, at the prices that they have described. When the goal is stated they are asked, and
 * the plan may be another one. Planned one after the other, on a thread of its own.
 */
final class Preview implements AutoCloseable {
  private final KnowledgeBase knowledge;
  private final Supplier<Collection<String>> present;
  private final OptimalPlanner planner = new OptimalPlanner();
  private final OneByOne planning =
      new OneByOne("console-preview", "Other plans are being made; ask again in a while.");

  /**
   * @param present the members that can be used now
   */
  Preview(KnowledgeBase knowledge, Supplier<Collection<String>> present) {
    this.knowledge = knowledge;
    this.present = present;
  }

  /** Completed with the plan, or with why there seems to be none. */
  CompletableFuture<JsonNode> of(String goal) {
    try {
      PlanningTask task = task(goal);
      Home home = knowledge.home();
      return planning.work(() -> PreviewDocument.of(task.goal(), planner.plan(task), home));
    } catch (SlSyntaxException | InvalidGoalException e) {
      return CompletableFuture.failedFuture(
          RefusalException.badInput(String.valueOf(e.getMessage())));
    }
  }

  private PlanningTask task(String text) {
    Home home = knowledge.home();
    Formula goal = SlParser.formula(text, home.vocabulary()::isFluent);
    new GoalCheck(home).check(goal);
    Formula wanted = goal instanceof Formula.Keep keep ? keep.body() : goal;
    return new PlanningTask(
        home.vocabulary(),
        snapshot(NamedPoints.of(goal)),
        DescribedFeatures.of(home, present.get()::contains),
        wanted,
        Set.of());
  }

  /** What is known now, with the points that the goal names. */
  private Snapshot snapshot(NamedPoints points) {
    knowledge.admit(points);
    try {
      return knowledge.snapshot();
    } finally {
      knowledge.dismiss(points);
    }
  }

  @Override
  public void close() {
    planning.close();
  }
}
