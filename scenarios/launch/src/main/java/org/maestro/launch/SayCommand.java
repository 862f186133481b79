package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.maestro.console.questions.Questions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Says something to a running platform as people speak, and tells what becomes of it. */
@Command(
    name = "say",
    description = "Say something to the running platform, as a person in a room of its home.",
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:done, answered, or asked back",
      "1:not reached",
      "2:not understood, or bad input",
      "3:no platform answers"
    })
final class SayCommand implements Callable<Integer> {
  private static final long LOOK_EVERY_MILLIS = 200;

  /** So often nothing new has to come after an answer; then it was the whole. */
  private static final int QUIET_LOOKS = 3;

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(arity = "1..*", paramLabel = "WORDS", description = "What is said.")
  private List<String> words;

  @Option(names = "--as", required = true, paramLabel = "PERSON", description = "Who speaks.")
  private String person;

  @Option(names = "--in", required = true, paramLabel = "ROOM", description = "In which room.")
  private String room;

  private final Set<String> pursued = new LinkedHashSet<>();
  private int code = ExitCode.DONE;
  private boolean answered;

  @Override
  public Integer call() throws InterruptedException {
    PrintWriter out = spec.commandLine().getOut();
    try (AskedPlatform asked = platform.ask()) {
      long last =
          asked
              .answer(questions -> questions.say(person, room, String.join(" ", words)))
              .path("number")
              .asLong();
      int quiet = 0;
      while (!pursued.isEmpty() || !answered || quiet < QUIET_LOOKS) {
        long seen = last;
        for (JsonNode entry : asked.answer(Questions::said).path("entries")) {
          long number = entry.path("number").asLong();
          if (number > seen) {
            last = number;
            if (entry.path("person").asText().equals(person)) {
              tell(entry, out);
            }
          }
        }
        quiet = last == seen ? quiet + 1 : 0;
        new CountDownLatch(1).await(LOOK_EVERY_MILLIS, TimeUnit.MILLISECONDS);
      }
    }
    return code;
  }

  private void tell(JsonNode entry, PrintWriter out) {
    String goal = entry.path("goal").asText("");
    String text = entry.path("text").asText();
    switch (entry.path("kind").asText()) {
      case "understood" -> {
        pursued.add(goal);
        answered = true;
        // What is stated in MAESTRO-SL is asked about by its id, what is said by saying so.
        out.println(text.startsWith("(") ? goal + ": " + text : text);
      }
      case "reached", "ended" -> {
        if (pursued.remove(goal) && entry.path("kind").asText().equals("ended")) {
          code = ExitCode.NOT_REACHED;
        }
        out.println(text);
      }
      case "misunderstood" -> {
        answered = true;
        code = ExitCode.BAD_INPUT;
        out.println(text);
      }
      case "said" -> {
        // One's own words, and those of who speaks as the same person elsewhere.
      }
      default -> {
        answered = answered || goal.isEmpty();
        out.println(text);
      }
    }
    out.flush();
  }
}
