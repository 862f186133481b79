package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.maestro.agents.content.GoalReport;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The outcome of a goal on a stage.
 *
 * @param goal as it was stated
 * @param story all it told, in order
 */
public record GoalOutcome(String goal, GoalReport report, List<StoryEntry> story) {
  public GoalOutcome {
    story = List.copyOf(story);
  }

  public boolean reached() {
    return report.reached();
  }

  /** Feature calls started. */
  public int calls() {
    return report.calls();
  }

  /** Plans made after the first. */
  public int replans() {
    return report.replans();
  }

  /** Simulated time from arrival to end. */
  public Duration duration() {
    return report.duration();
  }

  /** Values of the goal's free variables, by name without question mark. */
  public Map<String, Term> binding() {
    return report.binding();
  }

  /** Why it was not reached; empty when it was. */
  public String explanation() {
    return String.join(" ", report.reasons());
  }

  /** The story as lines with simulated seconds. */
  public String storyText() {
    StringBuilder text = new StringBuilder();
    for (StoryEntry entry : story) {
      text.append(SlPrinter.print(entry.at().toMillis() / 1000.0))
          .append(" s  ")
          .append(entry.text())
          .append('\n');
    }
    return text.toString();
  }
}
