package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Each agent of a room has the words of its own topics (A13, A73). */
class RoomsCommandTest {
  private static final int CONSTRUCTIONS = 3;
  private static final int WORDS = 4;

  private static String said(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    int code = Maestro.commandLine(stream, stream).execute(arguments);
    return code + " " + said.toString(StandardCharsets.UTF_8);
  }

  @Test
  void howManyWordsEachAgentKnowsIsListed() {
    Map<String, String[]> rowByAgent =
        said("rooms", "rooms")
            .lines()
            .skip(1)
            .map(line -> line.split(" {2,}", -1))
            .collect(Collectors.toMap(row -> row[0], row -> row));

    assertThat(rowByAgent.keySet())
        .containsExactlyInAnyOrder(
            "bathroom-agent", "bedroom-agent", "kitchen-agent", "living-agent");
    int kitchen = Integer.parseInt(rowByAgent.get("kitchen-agent")[WORDS]);
    int bedroom = Integer.parseInt(rowByAgent.get("bedroom-agent")[WORDS]);
    assertThat(kitchen).isGreaterThan(bedroom);
    assertThat(Integer.parseInt(rowByAgent.get("bedroom-agent")[CONSTRUCTIONS])).isPositive();
    assertThat(rowByAgent.get("bathroom-agent")).as("it passes all on").contains("0");
  }

  @Test
  void aHomeWhoseRoomsDoNotListenIsSaidToBeSo() {
    assertThat(said("rooms", "bob")).startsWith("0 No agent listens in a room of this home");
  }
}
