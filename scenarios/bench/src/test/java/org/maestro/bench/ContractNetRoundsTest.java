package org.maestro.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.ontology.home.Device;

class ContractNetRoundsTest {

  @Test
  void bothAreMeasured(@TempDir Path files) {
    List<Device> devices = List.copyOf(new LargeHome(2, 0, 0).home().devices().values());

    ContractNetRounds rounds =
        ContractNetRounds.measure(devices, files, 10, Duration.ofMillis(200));

    assertThat(rounds.agents()).isEqualTo(devices.size());
    assertThat(rounds.ours()).isPositive();
    assertThat(rounds.plain()).isPositive();
    assertThat(rounds.row().ratio()).isPresent();
  }
}
