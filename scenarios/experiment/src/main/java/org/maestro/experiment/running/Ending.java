package org.maestro.experiment.running;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.GoalReport;
import org.maestro.coordination.api.StoryEntry;

/**
 * The end of a goal, as the platform tells it.
 *
 * @param report empty when it did not end in time
 * @param story all it told, in order
 * @param begun simulated time at which it was stated
 */
public record Ending(
    String goal, Optional<GoalReport> report, List<StoryEntry> story, Duration begun) {
  public Ending {
    story = List.copyOf(story);
  }

  public boolean claimed() {
    return report.filter(GoalReport::reached).isPresent();
  }

  public int replans() {
    return report.map(GoalReport::replans).orElse(0);
  }

  public int calls() {
    return report.map(GoalReport::calls).orElse(0);
  }

  /** Simulated time from arrival to end; seconds, of a goal without end from arrival on. */
  public double seconds(Duration now) {
    return report.map(GoalReport::duration).orElse(now.minus(begun)).toMillis() / 1e3;
  }

  /** Why it was not reached, in the platform's words; empty when it says that it was. */
  public String explanation() {
    return report
        .map(ended -> String.join(" ", ended.reasons()))
        .orElse("It had not ended when time was up; last it told: " + lastSentence());
  }

  private String lastSentence() {
    return story.isEmpty() ? "nothing." : story.get(story.size() - 1).text();
  }

  /** Sentences of one kind. */
  public List<String> told(StoryEntry.Kind kind) {
    return story.stream().filter(entry -> entry.kind() == kind).map(StoryEntry::text).toList();
  }
}
