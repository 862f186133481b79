package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What docs/guide-experiments.md says can be typed, can be. */
class GuideTest {

  @Test
  void itsCommandsNameWhatThereIs() throws IOException {
    String guide = Files.readString(Path.of("../../docs/guide-experiments.md"));
    List<String> commands =
        guide.lines().filter(line -> line.startsWith("./maestro experiment ")).toList();

    assertThat(commands).hasSizeGreaterThan(4);
    for (String command : commands) {
      String[] words = command.strip().split("\\s+");
      if (Experiments.named(words[2]).isPresent()) {
        Experiments.settings(Experiments.named(words[2]).orElseThrow(), given(words)).settings();
      } else {
        assertThat(command).isEqualTo(commands.get(0));
      }
    }
    for (Experiment experiment : Experiments.all()) {
      assertThat(guide).contains("| `" + experiment.name() + "` |");
    }
  }

  private static Map<String, String> given(String[] words) {
    Map<String, String> given = new LinkedHashMap<>();
    for (int i = 0; i < words.length; i++) {
      if (words[i].equals("--set")) {
        String[] pair = Arrays.copyOf(words[i + 1].split("="), 2);
        given.put(pair[0], pair[1]);
      }
    }
    return given;
  }
}
