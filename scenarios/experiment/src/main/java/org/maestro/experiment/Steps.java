package org.maestro.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.drawing.Timeline;
import org.maestro.experiment.running.Ending;

/** The steps of a goal as its story tells them: an agent has one at a time. */
final class Steps {
  private static final Pattern BEGIN = Pattern.compile("Step \\d+ of \\d+: ((\\S+) .*)\\.");
  private static final double MILLIS = 1e3;

  private Steps() {}

  /** In the order in which they began, with seconds since the goal was stated. */
  static List<Timeline.Deed> of(Ending ending) {
    List<Timeline.Deed> steps = new ArrayList<>();
    Map<String, Integer> open = new LinkedHashMap<>();
    for (StoryEntry entry : ending.story()) {
      double at = seconds(entry.at(), ending.begun());
      Matcher begin = BEGIN.matcher(entry.text());
      if (entry.kind() == StoryEntry.Kind.STEP && begin.matches()) {
        end(steps, open, begin.group(2), at, false);
        open.put(begin.group(2), steps.size());
        steps.add(new Timeline.Deed(begin.group(2), begin.group(1), at, at, false));
      } else if (entry.kind() == StoryEntry.Kind.DONE || entry.kind() == StoryEntry.Kind.FAILED) {
        String who = entry.text().replaceFirst("^That failed: ", "").split(" ", 2)[0];
        end(steps, open, who, at, entry.kind() == StoryEntry.Kind.DONE);
      }
    }
    double end =
        ending.story().isEmpty()
            ? 0
            : seconds(ending.story().get(ending.story().size() - 1).at(), ending.begun());
    for (String who : List.copyOf(open.keySet())) {
      end(steps, open, who, end, false);
    }
    return List.copyOf(steps);
  }

  private static void end(
      List<Timeline.Deed> steps, Map<String, Integer> open, String who, double at, boolean done) {
    if (open.containsKey(who)) {
      int number = open.remove(who);
      Timeline.Deed step = steps.get(number);
      steps.set(number, new Timeline.Deed(who, step.what(), step.begin(), at, done));
    }
  }

  private static double seconds(Duration at, Duration begun) {
    return at.minus(begun).toMillis() / MILLIS;
  }
}
