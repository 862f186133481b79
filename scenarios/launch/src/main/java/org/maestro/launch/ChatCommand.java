package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Talks with a running platform as people speak, line by line. */
@Command(
    name = "chat",
    description =
        "Talk with the running platform, as a person in a room of its home, until Ctrl-D or exit.",
    footer = {
      "",
      "On a terminal the line can be edited, the arrow keys fetch earlier ones, and the words that"
          + " could come next are shown; the tabulator takes one. What comes in by a pipe is said"
          + " line by line."
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:ended by the person", "2:bad input", "3:no platform answers any more"})
final class ChatCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;
  @Mixin private SpeakerOptions speaker;

  @Override
  public Integer call() throws InterruptedException, IOException {
    try (AskedPlatform asked = platform.ask()) {
      // Who there is not, or where nothing is, is told before anything is said.
      nextWords(asked, "");
      try (Keyboard keyboard = keyboard(asked)) {
        return new ChatSession(keyboard, speaker.conversing(asked, keyboard::print)).converse();
      }
    }
  }

  private Keyboard keyboard(AskedPlatform asked) throws IOException {
    if (Optional.ofNullable(System.console()).isPresent()) {
      Terminal terminal = TerminalBuilder.builder().dumb(true).build();
      if (!terminal.getType().startsWith(Terminal.TYPE_DUMB)) {
        return new TerminalKeyboard(
            terminal, speaker.person() + "> ", text -> suggested(asked, text));
      }
      terminal.close();
    }
    return new PipedKeyboard(System.in, spec.commandLine().getOut());
  }

  /** Without an answer nothing is suggested; what is wrong is told when the line is said. */
  private List<String> suggested(AskedPlatform asked, String text) {
    try {
      return nextWords(asked, text);
    } catch (CommandException e) {
      return List.of();
    }
  }

  private List<String> nextWords(AskedPlatform asked, String text) {
    List<String> words = new ArrayList<>();
    for (JsonNode word :
        asked
            .answer(questions -> questions.nextWords(speaker.person(), speaker.room(), text))
            .path("words")) {
      words.add(word.asText());
    }
    return words;
  }
}
