package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class OpenFilesTest {

  @Test
  void tooFewAreNamedBeforeTheSiteIsOpened() {
    assertThatThrownBy(() -> OpenFiles.require(120, 100, 256))
        .isInstanceOf(SiteException.class)
        .hasMessageContaining("Only 256 files")
        .hasMessageContaining("120 devices")
        .hasMessageContaining("ulimit -n 4096");
    assertThatCode(() -> OpenFiles.require(10, 100, 256)).doesNotThrowAnyException();
  }
}
