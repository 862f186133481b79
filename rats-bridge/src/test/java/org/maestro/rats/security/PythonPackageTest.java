package org.maestro.rats.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.maestro.rats.broker.RunsProgram;

/** The package for devices in Python passes its own tests. */
@RunsProgram(value = "python3", pythonModule = "paho.mqtt.enums")
class PythonPackageTest {

  @Test
  void itsOwnTestsPass() throws IOException, InterruptedException {
    ProcessBuilder builder =
        new ProcessBuilder("python3", "-m", "unittest", "discover", "-s", "tests")
            .directory(Path.of("python").toFile())
            .redirectErrorStream(true);
    builder.environment().put("PYTHONPATH", "src");
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    Process tests = builder.start();
    String said = new String(tests.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

    assertThat(tests.waitFor()).as(said).isZero();
    assertThat(said).contains("OK").doesNotContain("Ran 0 tests");
  }
}
