package org.maestro.coordination.scripts;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Speech;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.sl.SlPrinter;

/** Tells how a script is carried out: what is done for its parts is part of its story. */
final class ScriptStory {
  /** The place of what a part of a part tells. */
  private static final Pattern PATH = Pattern.compile("\\[([\\d.]+)\\] (.*)", Pattern.DOTALL);

  private final String goalId;
  private final Ports ports;

  ScriptStory(String goalId, Ports ports) {
    this.goalId = goalId;
    this.ports = ports;
  }

  void begins(String path, String step) {
    tell(StoryEntry.Kind.STEP, path, step + ".");
  }

  /** Another script is run, with these for its parameters. */
  void runs(String path, String script) {
    tell(StoryEntry.Kind.STEP, path, "Run " + script + ".");
  }

  void gives(String path, String variable, String value) {
    tell(StoryEntry.Kind.KNOWN, path, "?%s is %s.".formatted(variable, value));
  }

  void answers(String path, String variable, String value, String who) {
    tell(
        StoryEntry.Kind.KNOWN,
        path,
        "?%s is %s, as %s has answered.".formatted(variable, value, who));
  }

  void waits(String path, String condition) {
    tell(StoryEntry.Kind.WAIT, path, "Waits until it is known that " + condition + ".");
  }

  void recovers(String path, String reason) {
    tell(StoryEntry.Kind.REPLAN, path, "Recovers from this: " + reason);
  }

  void states(String path, String facts) {
    tell(StoryEntry.Kind.LEARNT, path, "It is stated that " + facts + ".");
  }

  void says(String path, String who, String text) {
    tell(StoryEntry.Kind.SAID, path, "To %s: \"%s\"".formatted(who, text));
  }

  void expresses(String path, Mood mood) {
    tell(
        StoryEntry.Kind.SAID,
        path,
        "Shows that it is %s, by %s.".formatted(mood.word(), SlPrinter.print(mood.intensity())));
  }

  void asks(String path, Speech question) {
    tell(
        StoryEntry.Kind.SAID,
        path,
        "Asks %s: \"%s\" %sAnswer by ./maestro answer %s, or in the chat."
            .formatted(
                question.to(),
                question.text(),
                question.wanted().flatMap(Speech.Wanted::inWords).map(it -> it + " ").orElse(""),
                question.part()));
  }

  void tells(String path, String agent, String message) {
    tell(StoryEntry.Kind.SAID, path, "The agent %s is told %s.".formatted(agent, message));
  }

  void sees(String path, List<String> facts) {
    tell(StoryEntry.Kind.LEARNT, path, "Seen: " + String.join(", ", facts) + ".");
  }

  /** What the goal for a part tells, as the script tells it. */
  Story of(String path) {
    return entry -> {
      switch (entry.kind()) {
        case GOAL, KNOWN -> {
          // The step was told, and what is known of its things is known of the script's.
        }
        case END ->
            tell(
                entry.text().startsWith("Reached") ? StoryEntry.Kind.DONE : StoryEntry.Kind.FAILED,
                path,
                entry.text());
        default -> {
          Matcher ofAPart = PATH.matcher(entry.text());
          if (ofAPart.matches()) {
            tell(entry.kind(), path + "." + ofAPart.group(1), ofAPart.group(2));
          } else {
            tell(entry.kind(), path, entry.text());
          }
        }
      }
    };
  }

  /** The same of a component that is held: whatever becomes of the steps, it is let go. */
  Story ofHolding(String path, String component) {
    Story told = of(path);
    return entry -> {
      if (entry.kind() == StoryEntry.Kind.END) {
        tell(StoryEntry.Kind.DONE, path, "Lets go of %s.".formatted(component));
      } else {
        told.tell(entry);
      }
    };
  }

  private void tell(StoryEntry.Kind kind, String path, String text) {
    ports
        .story()
        .tell(new StoryEntry(goalId, ports.clock().now(), kind, "[%s] %s".formatted(path, text)));
  }
}
