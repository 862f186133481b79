package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.faults.FaultyDisk;
import org.maestro.platform.journal.StoryFile;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.time.SteppedClock;

/** Stories on a disk that fails have gaps; who tells them notices nothing. */
class StoryFaultsTest {
  @TempDir private Path directory;

  private static StoryEntry told(int number) {
    return new StoryEntry("G1", Duration.ofSeconds(number), StoryEntry.Kind.STEP, "Step " + number);
  }

  private List<String> kept() {
    return new StoryFile(directory).read("G1").stream().map(StoryEntry::text).toList();
  }

  @Test
  void whatTheDiskDoesNotTakeIsMissingAndNothingElse() {
    FaultyDisk disk = new FaultyDisk(7);
    try (StoryFile story = StoryFile.open(disk.path(directory), new SteppedClock())) {
      story.tell(told(1));
      disk.fillUpTo(20);
      story.tell(told(2));
      story.tell(told(3));
      disk.heal();
      story.tell(told(4));
      disk.tearNextWrite();
      story.tell(told(5));
      disk.takeAway();
      story.tell(told(6));
      disk.heal();
      disk.readOnly();
      story.tell(told(7));
      disk.heal();
      story.tell(told(8));
    }
    assertThat(kept()).containsExactly("Step 1", "Step 4", "Step 8");
  }

  @Test
  void whatIsPrivateIsSoAfterARestart() {
    StoryEntry entry = told(1).using(Set.of("prefers", "age"));
    try (StoryFile story = StoryFile.open(directory, new SteppedClock())) {
      story.tell(entry);
      story.tell(told(2));
    }
    assertThat(new StoryFile(directory).read("G1"))
        .extracting(StoryEntry::privateWords)
        .containsExactly(Set.of("prefers", "age"), Set.of());
  }

  @Test
  void aSlowDiskHoldsNobodyUp() {
    FaultyDisk disk = new FaultyDisk(7);
    try (PacedClock clock = new PacedClock(1)) {
      try (StoryFile story = StoryFile.open(disk.path(directory), clock)) {
        disk.stall();
        for (int number = 1; number <= 100; number++) {
          story.tell(told(number));
        }
        disk.heal();
      }
      assertThat(kept()).hasSize(100).startsWith("Step 1").endsWith("Step 100");
    }
  }
}
