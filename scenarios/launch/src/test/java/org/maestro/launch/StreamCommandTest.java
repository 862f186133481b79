package org.maestro.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.fixtures.WireTap;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.stream.Recording;
import org.maestro.rats.stream.RecordingWriter;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/**
 * Streams by command: received with their delays, recorded, analysed and played again (ADE, 3.3;
 * A44).
 */
class StreamCommandTest {
  private static final Instant CAPTURED = Instant.parse("2026-03-01T18:00:00Z");
  private static final String TONE = "audio/L16;rate=16000;channels=1";

  @TempDir private Path directory;

  private static String said(int expected, String... arguments) {
    ByteArrayOutputStream words = new ByteArrayOutputStream();
    PrintStream out = new PrintStream(words, true, UTF_8);
    int code = Maestro.commandLine(out, out).execute(arguments);
    assertThat(code).as(words.toString(UTF_8)).isEqualTo(expected);
    return words.toString(UTF_8);
  }

  /** A dark picture, then bright ones. */
  private Path pictures() throws IOException {
    return recording(
        "pictures.jsonl",
        "image/png",
        List.of(
            picture(25, 25),
            picture(204, 204),
            picture(204, 204),
            picture(204, 204),
            picture(204, 204),
            picture(51, 204)));
  }

  private Path recording(String name, String mediaType, List<byte[]> frames) {
    Path file = directory.resolve(name);
    try (RecordingWriter writer = RecordingWriter.create(file)) {
      for (int i = 0; i < frames.size(); i++) {
        Instant at = CAPTURED.plusMillis(400L * i);
        writer.add(new StreamFrame("c1", "cam", "film", i + 1, at, mediaType, frames.get(i)), at);
      }
    }
    return file;
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
    assertThat(ImageIO.read(new ByteArrayInputStream(png.toByteArray()))).isNotNull();
    return png.toByteArray();
  }

  private static byte[] tone(double hertz) {
    ByteBuffer samples = ByteBuffer.allocate(2 * 9_600);
    for (int i = 0; i < 9_600; i++) {
      samples.putShort((short) (8_000 * Math.sin(2 * Math.PI * hertz * i / 16_000)));
    }
    return samples.array();
  }

  @Test
  void whatIsPlayedArrivesUnharmedWithItsDelayAndIsAnalysedBesides() throws Exception {
    Path pictures = pictures();
    Path again = directory.resolve("again.jsonl");
    List<String> told = new CopyOnWriteArrayList<>();
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        WireTap tap = new WireTap(broker.uri().getPort());
        PacedClock clock = new PacedClock(1);
        RatsLink link =
            BusLink.connect("cca", "hall", new PahoTransport(broker.uri(), "cca"), clock);
        RunningCommand player = player(pictures, broker)) {
      link.watch(
          "looker", member -> member.state().ifPresent(state -> told.addAll(state.values())));
      String said = stream(tap.port(), "--to", again.toString(), "--analyse-as", "looker");
      assertThat(said)
          .contains("player streams (replay).")
          .containsPattern("6 frames \\([0-9]+ kB\\) in [0-9.]+ s; 0 did not arrive, in 0 gaps\\.")
          .containsPattern(
              "Delay from capture to arrival: p50 [0-9.]+ ms, p99 [0-9.]+ ms, at most [0-9.]+"
                  + " ms\\.");
      List<StreamFrame> before = Recording.read(pictures).frames();
      List<StreamFrame> after = Recording.read(again).frames();
      assertThat(after).hasSize(6);
      for (int i = 0; i < 6; i++) {
        assertThat(after.get(i).data()).isEqualTo(before.get(i).data());
        assertThat(after.get(i).number()).isEqualTo(i + 1);
      }
      assertThat(tap.hasHeard(Base64.getEncoder().encodeToString(before.get(0).data())))
          .as("on an open site it is read on the wire; on a secured one it must not be")
          .isTrue();
      Awaitility.await()
          .atMost(Duration.ofSeconds(30))
          .untilAsserted(
              () ->
                  assertThat(told)
                      .as(player::said)
                      .contains(
                          "(= (frameBrightness looker) 0.1)",
                          "(= (frameMotion looker) 1)",
                          "(= (frameBrightness looker) 0.8)"));
    }
  }

  @Test
  void aToneIsHeardByItsPitchAndWhatIsAskedWronglyIsToldInASentence() throws Exception {
    Path tones = recording("tones.jsonl", TONE, List.of(tone(440), tone(440)));
    List<String> told = new CopyOnWriteArrayList<>();
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PacedClock clock = new PacedClock(1);
        RatsLink link =
            BusLink.connect("cca", "hall", new PahoTransport(broker.uri(), "cca"), clock);
        RunningCommand player = player(tones, broker)) {
      link.watch(
          "looker", member -> member.state().ifPresent(state -> told.addAll(state.values())));
      stream(broker.uri().getPort(), "--analyse-as", "looker");
      Awaitility.await()
          .atMost(Duration.ofSeconds(30))
          .untilAsserted(
              () ->
                  assertThat(told)
                      .as(player::said)
                      .anyMatch(
                          fact -> fact.matches("\\(= \\(soundPitch looker\\) 4(3[5-9]|4[0-5]).*"))
                      .contains("(= (soundStrength looker) 0.17)"));
      assertThat(
              said(
                  ExitCode.OUTSIDE,
                  "stream",
                  "player",
                  "--broker",
                  broker.uri().toString(),
                  "--site",
                  "hall"))
          .contains("maestro: player does not stream (streamPictures): ")
          .doesNotContain("\tat ");
    }
    assertThat(said(ExitCode.BAD_INPUT, "stream"))
        .contains("Name either the MEMBER whose stream is wanted, or a recording");
    assertThat(said(ExitCode.BAD_INPUT, "stream", "--replay", "x.jsonl"))
        .contains("--replay FILE and --as ID belong together");
    assertThat(said(ExitCode.BAD_INPUT, "stream", "cam-a", "--for", "-3"))
        .contains("--for takes seconds above 0");
    assertThat(said(ExitCode.OUTSIDE, "stream", "--replay", tones + "x", "--as", "player"))
        .contains("cannot be read");
  }

  private static RunningCommand player(Path recording, EmbeddedBroker broker) {
    return new RunningCommand(
        "stream",
        "--replay",
        recording.toString(),
        "--as",
        "player",
        "--broker",
        broker.uri().toString(),
        "--site",
        "hall");
  }

  private static String stream(int port, String... more) {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "stream",
                "player",
                "--feature",
                "replay",
                "--broker",
                "tcp://127.0.0.1:" + port,
                "--site",
                "hall"));
    arguments.addAll(List.of(more));
    return said(ExitCode.DONE, arguments.toArray(new String[0]));
  }
}
