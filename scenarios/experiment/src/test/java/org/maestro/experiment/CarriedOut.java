package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import javax.imageio.ImageIO;
import org.maestro.experiment.drawing.Figure;

/** Experiments as tests carry them out, and what must be true of all their findings. */
final class CarriedOut {
  private CarriedOut() {}

  static Findings findings(String name, int runs, long seed, Map<String, String> given) {
    Experiment experiment = Experiments.named(name).orElseThrow();
    return experiment.carryOut(
        new Request(runs, seed, Experiments.settings(experiment, given).settings(), false),
        (done, of, line) -> {});
  }

  /** The page needs nothing beside it, and no figure is blank. */
  static void assertReadable(Findings findings) throws IOException {
    String html = findings.page().html();
    assertThat(html.replaceAll("base64,[A-Za-z0-9+/=]+", ""))
        .doesNotContain("http:")
        .doesNotContain("https:")
        .doesNotContain("<script")
        .doesNotContain("<link")
        .doesNotContain("src=\"/")
        .doesNotContain("NaN");
    assertThat(findings.figures()).isNotEmpty();
    for (Figure figure : findings.figures()) {
      BufferedImage image = ImageIO.read(new ByteArrayInputStream(figure.png()));
      assertThat(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
          .as(figure.name())
          .satisfies(
              pixels -> assertThat(Arrays.stream(pixels).distinct().count()).isGreaterThan(20));
      assertThat(html.replace("&quot;", "\""))
          .as("the caption of " + figure.name())
          .matches(page -> page.contains(figure.caption().substring(0, 12)));
    }
    assertThat(findings.tables()).containsKey("runs");
  }
}
