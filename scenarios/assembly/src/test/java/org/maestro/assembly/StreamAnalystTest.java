package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;

/**
 * What an analyst far from the camera tells of its frames (ADE, 3.3; A44), on the stepped clock.
 */
class StreamAnalystTest {
  private static final String PICTURE = "image/png";
  private static final String SOUND = "audio/L16;rate=16000;channels=1";

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final List<List<String>> told = new ArrayList<>();
  private RatsLink link;
  private StreamAnalyst analyst;

  @BeforeEach
  void join() {
    link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    link.watch("looker", member -> member.state().ifPresent(state -> told.add(state.values())));
    analyst = StreamAnalyst.start("looker", CallPolicy.OPEN, bus.client("looker"), "home", clock);
    clock.run(Duration.ofSeconds(1));
  }

  @AfterEach
  void leave() {
    analyst.close();
    link.close();
    clock.run(Duration.ofSeconds(1));
  }

  private void frame(String mediaType, byte[] data, int millisUntilNext) {
    analyst.add(new StreamFrame("c1", "cam", "film", 1, clock.instant(), mediaType, data));
    clock.run(Duration.ofMillis(millisUntilNext));
  }

  private List<String> latest() {
    return told.get(told.size() - 1);
  }

  private static byte[] picture(int upper, int lower) throws IOException {
    BufferedImage image = new BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB);
    for (int row = 0; row < 20; row++) {
      int grey = row < 10 ? upper : lower;
      for (int column = 0; column < 40; column++) {
        image.setRGB(column, row, grey << 16 | grey << 8 | grey);
      }
    }
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    ImageIO.write(image, "png", png);
    return png.toByteArray();
  }

  private static byte[] tone(double hertz, int amplitude) {
    ByteBuffer samples = ByteBuffer.allocate(2 * 1_600);
    for (int i = 0; i < 1_600; i++) {
      samples.putShort((short) (amplitude * Math.sin(2 * Math.PI * hertz * i / 16_000)));
    }
    return samples.array();
  }

  @Test
  void brightnessAndMotionOfPicturesAreTold() throws IOException {
    assertThat(latest()).as("nothing before the first frame").isEmpty();
    frame(PICTURE, picture(25, 25), 1000);
    assertThat(latest())
        .containsExactly("(= (frameBrightness looker) 0.1)", "(= (frameMotion looker) 0)");
    frame(PICTURE, picture(204, 204), 1000);
    assertThat(latest())
        .containsExactly("(= (frameBrightness looker) 0.8)", "(= (frameMotion looker) 1)");
    frame(PICTURE, picture(0, 204), 1000);
    assertThat(latest())
        .containsExactly("(= (frameBrightness looker) 0.4)", "(= (frameMotion looker) 0.5)");
    frame(PICTURE, picture(20, 204), 1000);
    assertThat(latest()).as("that is noise").contains("(= (frameMotion looker) 0)");
  }

  @Test
  void whatIsOverInAMomentIsToldAllTheSame() throws IOException {
    frame(PICTURE, picture(25, 25), 1000);
    int before = told.size();
    frame(PICTURE, picture(25, 25), 100);
    frame(PICTURE, picture(204, 25), 100);
    frame(PICTURE, picture(204, 25), 1000);
    assertThat(told.size() - before).as("half a second apart at least").isLessThanOrEqualTo(2);
    assertThat(latest()).contains("(= (frameMotion looker) 0.5)");
  }

  @Test
  void strengthAndPitchOfSoundAreTold() {
    frame(SOUND, tone(440, 16_384), 1000);
    assertThat(latest())
        .anyMatch(fact -> fact.matches("\\(= \\(soundPitch looker\\) 4(3|4)\\d\\)"))
        .anyMatch(fact -> fact.matches("\\(= \\(soundStrength looker\\) 0\\.35\\)"));
    frame(SOUND, tone(440, 20), 1000);
    assertThat(latest()).contains("(= (soundPitch looker) 0)", "(= (soundStrength looker) 0)");
  }

  @Test
  void whatNobodyKnowsHereIsLeftAlone() {
    frame("image/webp", new byte[] {1, 2, 3}, 1000);
    frame("audio/ogg", new byte[] {1, 2, 3}, 1000);
    assertThat(latest()).isEmpty();
  }
}
