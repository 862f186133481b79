package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** Where the system lets a process open few files, one sentence says so before anything begins. */
class FewFilesTest {

  @Test
  void oneSentenceNamesTheCause() throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder("bash", "-c", "ulimit -n 64; ../../maestro demo")
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

    assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
    assertThat(Path.of("../../maestro")).exists();
    assertThat(process.exitValue()).isEqualTo(ExitCode.OUTSIDE);
    assertThat(said.lines())
        .singleElement()
        .asString()
        .startsWith("maestro: Only 64 files may be open")
        .contains("ulimit -n 4096");
  }
}
