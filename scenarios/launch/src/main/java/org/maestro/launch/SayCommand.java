package org.maestro.launch;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
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
  private static final int LONGEST_WORD = 5;

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;
  @Mixin private SpeakerOptions speaker;

  @Parameters(arity = "1..*", paramLabel = "WORDS", description = "What is said.")
  private List<String> words;

  @Option(
      names = "--trace",
      description =
          "Say it word by word, as a microphone would hear it, and show what is looked at, begun"
              + " and done meanwhile.")
  private boolean trace;

  @Option(
      names = "--word-seconds",
      paramLabel = "S",
      defaultValue = "0.3",
      description = "From one word to the next, with --trace; default ${DEFAULT-VALUE}.")
  private double wordSeconds;

  @Override
  public Integer call() throws InterruptedException {
    PrintWriter out = spec.commandLine().getOut();
    if (!(wordSeconds >= 0 && wordSeconds <= LONGEST_WORD)) {
      throw CommandException.badInput(
          "--word-seconds has to be from 0 to %d.".formatted(LONGEST_WORD));
    }
    try (AskedPlatform asked = platform.ask()) {
      if (trace) {
        return new SpokenTrace(asked, speaker.person(), speaker.room(), out)
            .say(List.of(String.join(" ", words).strip().split("\\s+")), wordSeconds);
      }
      Conversing conversation =
          speaker.conversing(
              asked,
              line -> {
                out.println(line);
                out.flush();
              });
      conversation.say(String.join(" ", words));
      while (!conversation.isAnswered() || conversation.isPursued()) {
        conversation.look();
        new CountDownLatch(1).await(LOOK_EVERY_MILLIS, TimeUnit.MILLISECONDS);
      }
      return conversation.code();
    }
  }
}
