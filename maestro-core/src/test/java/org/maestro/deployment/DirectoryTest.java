package org.maestro.deployment;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.junit.jupiter.api.Test;

/** The tables: global, local and of containers (Three-layered architecture, 3.3.1; M66). */
class DirectoryTest {
  private static final Instant FIRST = Instant.parse("2020-01-01T10:00:00Z");
  private static final Instant LATER = FIRST.plusSeconds(60);

  private final Directory directory = new Directory();

  @Test
  void anAgentThatMovesChangesLocalTablesAndItsTime() {
    directory.joined("lights", "10.0.0.1:1099", FIRST);
    directory.joined("attic", "10.0.0.2:1099", FIRST);
    directory.born("lamp-1", "lights", FIRST);
    assertThat(directory.agentsIn("lights")).hasSize(1);

    directory.moved("lamp-1", "attic", LATER);

    assertThat(directory.agentsIn("lights")).isEmpty();
    assertThat(directory.agentsIn("attic"))
        .containsExactly(new Directory.Entry("lamp-1", "attic", "active", LATER));
    assertThat(directory.containers()).extracting(Directory.Place::name).contains("lights");
  }

  @Test
  void aSuspendedAgentIsSinceThen() {
    directory.born("lamp-1", "lights", FIRST);
    directory.becomes("lamp-1", "suspended", LATER);

    assertThat(directory.find("lamp-1"))
        .contains(new Directory.Entry("lamp-1", "lights", "suspended", LATER));
  }

  @Test
  void whoLeavesTakesItsAgentsAlong() {
    directory.joined("attic", "10.0.0.2:1099", FIRST);
    directory.born("lamp-1", "attic", FIRST);
    directory.born("lamp-2", "lights", FIRST);

    directory.left("attic");

    assertThat(directory.agents()).extracting(Directory.Entry::agent).containsExactly("lamp-2");
    assertThat(directory.containers()).isEmpty();
  }
}
