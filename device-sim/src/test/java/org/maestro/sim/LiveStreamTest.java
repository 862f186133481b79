package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ShortBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.stream.StreamFigures;
import org.maestro.rats.stream.StreamReceiver;

/** What rooms' cameras and microphones stream to whoever asks them (ADE, 3.3; A44). */
class LiveStreamTest {
  private final List<StreamReceiver.Received> received = new ArrayList<>();
  private final List<Optional<String>> ends = new ArrayList<>();
  private final StreamFigures figures = new StreamFigures();

  private StreamReceiver receive(
      Homes homes, String member, String feature, Map<String, Object> parameters) {
    StreamReceiver receiver =
        StreamReceiver.open(
            new StreamReceiver.Wanted(member, feature, parameters),
            "screen",
            "test",
            homes.bus.client("screen"),
            homes.clock,
            SiteKind.OPEN,
            new StreamReceiver.Listener() {
              @Override
              public void received(StreamReceiver.Received one) {
                received.add(one);
                figures.add(one);
              }

              @Override
              public void ended(Optional<String> reason) {
                ends.add(reason);
              }
            });
    homes.clock.run(Duration.ofSeconds(1));
    return receiver;
  }

  private static Homes rooms() {
    return new Homes("rooms", "rooms", 1, scene -> scene);
  }

  private static Homes parlour() {
    return new Homes("parlour", "parlour", 1, scene -> scene);
  }

  private StreamFrame latest() {
    return received.get(received.size() - 1).frame();
  }

  private static BufferedImage picture(StreamFrame frame) throws IOException {
    assertThat(frame.mediaType()).isEqualTo("image/png");
    return ImageIO.read(new ByteArrayInputStream(frame.data()));
  }

  private static double brightness(BufferedImage picture) {
    double sum = 0;
    for (int rgb : picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, 160)) {
      sum += rgb >> 8 & 0xff;
    }
    return sum / (picture.getWidth() * picture.getHeight());
  }

  @Test
  void picturesOfTheKitchenArriveInOrderAndTheDelayIsKnown() throws IOException {
    try (Homes homes = rooms()) {
      receive(homes, "cam-kitchen", "streamPictures", Map.of());
      homes.clock.run(Duration.ofSeconds(4));
      assertThat(received).hasSizeBetween(8, 10);
      assertThat(received.stream().map(one -> one.frame().number()))
          .isSorted()
          .doesNotHaveDuplicates();
      assertThat(figures.missed()).isZero();
      assertThat(figures.delay(0.99).orElseThrow().toMillis()).isEqualTo(1);
      BufferedImage lit = picture(latest());
      assertThat(lit.getWidth()).isEqualTo(160);
      assertThat(lit.getHeight()).isEqualTo(90);

      homes.world().lighting().setLevel("kitchen-lamp", 0);
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(brightness(picture(latest()))).isLessThan(0.8 * brightness(lit));
    }
  }

  /** The very pixels of the camera, for a picture is sent without loss. */
  @Test
  void aPictureIsTheOneThatTheCameraTook() throws IOException {
    try (Homes homes = rooms()) {
      receive(homes, "cam-kitchen", "streamPictures", Map.of("width", 64, "frequency", 5));
      List<Photo> taken = new ArrayList<>();
      StreamFrame frame = latest();
      homes
          .simulated
          .drivers("cam-kitchen")
          .find(Camera.class)
          .orElseThrow()
          .photograph(
              64,
              new Camera.PhotoListener() {
                @Override
                public void taken(Photo photo) {
                  taken.add(photo);
                }

                @Override
                public void failed(String reason) {
                  throw new AssertionError(reason);
                }
              });
      int before = received.size();
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(taken).hasSize(1);
      assertThat(picture(frame).getWidth()).isEqualTo(64);
      assertThat(received.size() - before).isBetween(4, 6);
      Photo photo = taken.get(0);
      // Taken at another moment: the same but for the noise.
      BufferedImage image = picture(latest());
      int alike = 0;
      for (int row = 0; row < photo.height(); row++) {
        for (int column = 0; column < photo.width(); column++) {
          int one = photo.at(column, row) >> 8 & 0xff;
          int other = image.getRGB(column, row) >> 8 & 0xff;
          alike += Math.abs(one - other) < 40 ? 1 : 0;
        }
      }
      assertThat((double) alike / (photo.width() * photo.height())).isGreaterThan(0.97);
    }
  }

  @Test
  void theTestToneOfAMicrophoneArrivesUnbroken() {
    try (Homes homes = parlour()) {
      receive(homes, "microphone", "streamSound", Map.of("tone", 440));
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(latest().mediaType()).isEqualTo("audio/L16;rate=16000;channels=1");
      short[] heard = samples(received.subList(0, 20));
      assertThat(heard).hasSize(32_000);
      // One missing sample at a seam would take the phase away, and with it the tone's share.
      assertThat(shareOf(440, heard)).isGreaterThan(0.99);
      assertThat(shareOf(450, heard)).isLessThan(0.01);
      assertThat(figures.missed()).isZero();
      assertThat(figures.delay(0.5).orElseThrow().toMillis()).isEqualTo(101);
    }
  }

  @Test
  void aRoomIsHeardWhileSomebodySpeaksInIt() {
    try (Homes homes = parlour()) {
      receive(homes, "microphone", "streamSound", Map.of());
      double quiet = strength(samples(received));
      received.clear();
      homes.world().talk().say("Dave", "it is rather dark in here");
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(strength(samples(received))).isGreaterThan(20 * quiet);
    }
  }

  @Test
  void whatNoStreamHasIsRefusedInASentence() {
    try (Homes homes = rooms();
        Homes parlour = parlour()) {
      receive(homes, "cam-kitchen", "streamPictures", Map.of("width", 1920));
      receive(parlour, "microphone", "streamSound", Map.of("tone", 9000));
      receive(homes, "lux-kitchen", "streamPictures", Map.of());
      assertThat(ends.get(0))
          .contains("The parameter width lies between 32 and 240 pixels, but is 1920.0.");
      assertThat(ends.get(1))
          .contains("The parameter tone lies between 20.0 and 8000.0 Hz, but is 9000.0.");
      assertThat(ends.get(2).orElseThrow()).contains("streamPictures");
      assertThat(received).isEmpty();
    }
  }

  @Test
  void whoeverMayCallTheDeviceEndsItsStreams() {
    try (Homes homes = rooms()) {
      receive(homes, "cam-kitchen", "streamPictures", Map.of());
      homes.link.call(
          "cam-kitchen",
          "stopStreaming",
          Map.of(),
          Duration.ofSeconds(5),
          Optional.empty(),
          result -> {});
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(ends).containsExactly(Optional.empty());
      int until = received.size();
      homes.clock.run(Duration.ofSeconds(5));
      assertThat(received).hasSize(until);
    }
  }

  @Test
  void aCameraThatDiesStreamsNoMoreAndItsReceiverIsTold() {
    try (Homes homes = rooms()) {
      receive(homes, "cam-kitchen", "streamPictures", Map.of());
      homes.world().die("cam-kitchen");
      homes.clock.run(Duration.ofSeconds(30));
      assertThat(ends).hasSize(1);
      assertThat(ends.get(0)).isPresent();
    }
  }

  private static short[] samples(List<StreamReceiver.Received> frames) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    frames.forEach(one -> all.writeBytes(one.frame().data()));
    ShortBuffer buffer = ByteBuffer.wrap(all.toByteArray()).asShortBuffer();
    short[] samples = new short[buffer.remaining()];
    buffer.get(samples);
    return samples;
  }

  private static double strength(short[] samples) {
    double sum = 0;
    for (short sample : samples) {
      sum += (double) sample * sample;
    }
    return Math.sqrt(sum / samples.length);
  }

  /** Which share of the power is in a sine of that pitch. */
  private static double shareOf(double hertz, short[] samples) {
    double cosine = 0;
    double sine = 0;
    double power = 0;
    for (int i = 0; i < samples.length; i++) {
      double angle = 2 * Math.PI * hertz * i / 16_000;
      cosine += samples[i] * Math.cos(angle);
      sine += samples[i] * Math.sin(angle);
      power += (double) samples[i] * samples[i];
    }
    return 2 * (cosine * cosine + sine * sine) / samples.length / power;
  }
}
