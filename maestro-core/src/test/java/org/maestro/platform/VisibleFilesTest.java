package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.journal.JournalLine;
import org.maestro.platform.journal.StoryFile;
import org.maestro.rats.time.SteppedClock;
import org.maestro.text.VisibleText;

/**
 * What a terminal would obey is not in the files, which are read in terminals, and nothing is lost.
 */
class VisibleFilesTest {
  private static final String SAID = "a\u009b2J \u202egnp\u2066\u007f\u2028\u001b\r\nb";

  @TempDir private Path directory;

  @Test
  void aStoryShowsWhatWouldBeObeyed() throws Exception {
    try (StoryFile story = StoryFile.open(directory, new SteppedClock())) {
      story.tell(new StoryEntry("G1", Duration.ZERO, StoryEntry.Kind.STEP, SAID));
    }
    String kept = Files.readString(directory.resolve("G1.jsonl"));
    assertThat(kept)
        .isEqualTo(VisibleText.line(kept.strip()) + "\n")
        .contains("\\u009b", "\\u202e");
    assertThat(new StoryFile(directory).read("G1").get(0).text()).isEqualTo(SAID);
  }

  @Test
  void soDoesALineOfTheJournal() throws Exception {
    String line = JournalLine.write(1, "", new ObjectMapper().createObjectNode().put("by", SAID));

    assertThat(line).contains("\\u009b", "\\u202e", "\\u007f").isEqualTo(VisibleText.line(line));
    assertThat(JournalLine.read(line).path("by").asText()).isEqualTo(SAID);
  }
}
