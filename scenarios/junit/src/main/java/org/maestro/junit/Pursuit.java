package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.GoalReport;
import org.maestro.assembly.LocalSite;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.sl.Formula;

/** A goal under way, during which a test may change the world. For the test's thread. */
public final class Pursuit {

  private final LocalSite site;
  private final String goal;
  private final Duration patience;
  private final AtomicReference<String> id = new AtomicReference<>("");
  private final AtomicReference<@Nullable GoalReport> report = new AtomicReference<>();
  private final List<StoryEntry> stories = new CopyOnWriteArrayList<>();

  private Pursuit(LocalSite site, String goal, Duration patience) {
    this.site = site;
    this.goal = goal;
    this.patience = patience;
  }

  static Pursuit begin(LocalSite site, String text, Formula goal, Duration patience) {
    Pursuit pursuit = new Pursuit(site, text, patience);
    site.platform().onStory(pursuit.stories::add);
    site.platform().desk().pursue(goal, pursuit.id::set, pursuit.report::set);
    return pursuit;
  }

  static Pursuit begin(LocalSite site, AskedGoal goal, Duration patience) {
    Pursuit pursuit = new Pursuit(site, goal.goal(), patience);
    site.platform().onStory(pursuit.stories::add);
    site.platform().desk().pursue(goal, pursuit.id::set, pursuit.report::set);
    return pursuit;
  }

  static Pursuit refused(LocalSite site, String text, String reason) {
    Pursuit pursuit = new Pursuit(site, text, Duration.ZERO);
    pursuit.report.set(GoalReport.refused(reason));
    return pursuit;
  }

  /**
   * Lets time pass until the goal's story tells this; fails the test when the goal ends, or
   * patience does, before.
   */
  public Pursuit awaitTelling(String part) {
    boolean told =
        site.runUntil(() -> tells(part) || report.get() != null, patience) && tells(part);
    if (!told) {
      throw new StageException(
          "The story of " + goal + " never told \"" + part + "\"; it was:\n" + outcomeSoFar());
    }
    return this;
  }

  /** Lets time pass until the goal has ended; fails the test when it does not. */
  public GoalOutcome await() {
    if (!site.runUntil(() -> report.get() != null, patience)) {
      throw new StageException(
          "The goal "
              + goal
              + " did not end within "
              + patience
              + "; its story is:\n"
              + outcomeSoFar());
    }
    return outcome(Objects.requireNonNull(report.get()));
  }

  private boolean tells(String part) {
    return own().stream().anyMatch(entry -> entry.text().contains(part));
  }

  private String outcomeSoFar() {
    return outcome(GoalReport.refused("not ended")).storyText();
  }

  private GoalOutcome outcome(GoalReport ended) {
    return new GoalOutcome(goal, ended, own());
  }

  private List<StoryEntry> own() {
    return stories.stream().filter(entry -> entry.goalId().equals(id.get())).toList();
  }
}
