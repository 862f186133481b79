package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import org.maestro.console.documents.StoryDocument;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.journal.StoryFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Tells a goal's story: from the running platform, or from what the last one left. */
@Command(
    name = "why",
    description =
        "Tell a goal's story: what was known, bid, planned, done, and why it was planned again.")
final class WhyCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(paramLabel = "GOAL", description = "A goal's id, such as G1.")
  private String goal;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Option(
      names = "--step",
      paramLabel = "N",
      description = "Why this member does that step of the latest plan, and not another.")
  private Optional<Integer> step = Optional.empty();

  @Option(
      names = "--plan",
      paramLabel = "N",
      description =
          "With --step: of the plan with that number, as in the story; the latest few are kept.")
  private Optional<Integer> plan = Optional.empty();

  @Override
  public Integer call() {
    if (plan.isPresent() && step.isEmpty()) {
      throw CommandException.badInput("--plan says of which plan the step is; add --step N.");
    }
    if (step.isPresent() && !platform.isThere()) {
      throw CommandException.badInput(
          "No platform runs, and what its plans were chosen from ended with it: only stories are"
              + " kept; leave --step away for the story.");
    }
    JsonNode document = platform.isThere() ? asked() : StoryDocument.of(goal, left());
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(document);
    } else {
      List<StoryEntry> story = StoryDocument.read(document);
      StoryPrinter printer = new StoryPrinter(out, story.get(0).at());
      story.forEach(printer::print);
    }
    return ExitCode.DONE;
  }

  private JsonNode asked() {
    try (AskedPlatform asked = platform.ask()) {
      return asked.answer(questions -> questions.story(goal, number(plan), number(step)));
    }
  }

  private static OptionalInt number(Optional<Integer> given) {
    return given.map(OptionalInt::of).orElseGet(OptionalInt::empty);
  }

  private List<StoryEntry> left() {
    StoryFile stories =
        RuntimeDirectory.ofUser()
            .lastStories()
            .map(StoryFile::new)
            .orElseThrow(
                () ->
                    CommandException.outside(
                        "No platform runs, and none left a story; start with ./maestro demo"));
    List<StoryEntry> story = stories.read(goal);
    if (story.isEmpty()) {
      List<String> known = stories.goals();
      throw CommandException.badInput(
          known.isEmpty()
              ? "No platform runs, and the last one left no story; start with ./maestro demo"
              : "There is no story of %s; there are %s.".formatted(goal, String.join(", ", known)));
    }
    return story;
  }
}
