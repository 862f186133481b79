package org.maestro.rats.stream;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.Disturbance;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Streams of pictures and sound over the bus (ADE, 3.3; A44), on the stepped clock. */
class StreamReceiverTest {
  private static final String PICTURES = "image/png";
  private static final String SOUND = "audio/L16;rate=16000;channels=1";

  @TempDir Path directory;

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final List<Message> onTheBus = new ArrayList<>();
  private final StreamFigures figures = new StreamFigures();
  private final List<StreamReceiver.Received> received = new ArrayList<>();
  private final List<Optional<String>> ends = new ArrayList<>();
  private boolean hasBegun;

  @BeforeEach
  void listenIn() {
    Transport witness = bus.client("witness");
    witness.subscribe(
        "rats/1/home/member/+/stream/+", Transport.RetainedMessages.IGNORE, onTheBus::add);
    witness.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // What it hears is what counts.
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
  }

  private void member(String id, String feature, Procedure procedure) {
    RatsMember.start(
        Filming.profile(id, feature, procedure), List::of, bus.client(id), "home", clock);
  }

  private void camera(String mediaType) {
    member("cam", "film", new Filming("cam", mediaType, clock));
    run(1);
  }

  private StreamReceiver receive(String member, String feature) {
    StreamReceiver receiver =
        StreamReceiver.open(
            new StreamReceiver.Wanted(member, feature, Map.of()),
            "screen",
            "home",
            bus.client("screen"),
            clock,
            SiteKind.OPEN,
            new Screen());
    clock.run(Duration.ofMillis(50));
    return receiver;
  }

  private void run(double seconds) {
    clock.run(Duration.ofMillis(Math.round(1000 * seconds)));
  }

  @Test
  void framesArriveInOrderAndUnharmedWithTheirDelay() {
    camera(PICTURES);
    receive("cam", "film");
    run(2);
    assertThat(hasBegun).isTrue();
    assertThat(received).hasSizeBetween(18, 20);
    for (int i = 0; i < received.size(); i++) {
      StreamFrame frame = received.get(i).frame();
      assertThat(frame.number()).isEqualTo(i + 1);
      assertThat(frame.mediaType()).isEqualTo(PICTURES);
      assertThat(frame.data()).isEqualTo(Filming.data(i + 1));
    }
    assertThat(figures.frames()).isEqualTo(received.size());
    assertThat(figures.missed()).isZero();
    // One hop of the bus, of one millisecond.
    assertThat(figures.delay(0.5)).contains(Duration.ofMillis(1));
    assertThat(figures.delay(0.99)).contains(Duration.ofMillis(1));
  }

  @Test
  void nothingStreamsUnaskedAndNothingAfterTheEnd() {
    camera(PICTURES);
    run(5);
    assertThat(onTheBus).isEmpty();
    StreamReceiver receiver = receive("cam", "film");
    run(1);
    receiver.close();
    run(1);
    int atTheEnd = onTheBus.size();
    run(5);
    assertThat(receiver.left()).isDone();
    assertThat(ends).containsExactly(Optional.empty());
    assertThat(onTheBus).hasSize(atTheEnd).hasSizeGreaterThan(5);
  }

  @Test
  void whoVanishesHasNothingStreamedForLong() {
    camera(PICTURES);
    receive("cam", "film");
    run(1);
    bus.cut("screen");
    run(60);
    int until = onTheBus.size();
    run(60);
    assertThat(onTheBus).hasSize(until);
  }

  @Test
  void gapsAreTold() {
    camera(PICTURES);
    bus.disturb(
        new Disturbance() {
          private int count;

          @Override
          public List<Copy> published(String client, Publication publication) {
            boolean isLost = publication.topic().contains("/stream/") && ++count % 5 == 0;
            return isLost ? List.of() : Disturbance.super.published(client, publication);
          }
        });
    receive("cam", "film");
    run(2.1);
    assertThat(figures.missed()).isEqualTo(figures.gaps()).isBetween(3L, 4L);
    assertThat(received.stream().filter(one -> one.missed() == 1).map(one -> one.frame().number()))
        .containsAnyOf(6L, 11L, 16L);
  }

  @Test
  void onASlowBusTheNewestPictureWinsAndEachIsAsNewAsCanBe() {
    camera(PICTURES);
    receive("cam", "film");
    bus.slow("cam", Duration.ofMillis(349));
    run(6);
    assertThat(figures.missed()).isGreaterThan(30);
    assertThat(figures.delay(1).orElseThrow()).isLessThanOrEqualTo(Duration.ofMillis(700));
    assertThat(received.get(received.size() - 1).frame().number()).isGreaterThan(50);
  }

  @Test
  void onASlowBusSoundIsKeptForTwoSecondsBeforeAnyIsGivenUp() {
    camera(SOUND);
    receive("cam", "film");
    bus.slow("cam", Duration.ofMillis(149));
    run(4);
    assertThat(figures.missed()).isZero();
    run(12);
    assertThat(figures.missed()).isPositive();
    assertThat(figures.delay(1).orElseThrow()).isLessThanOrEqualTo(Duration.ofMillis(3_500));
  }

  @Test
  void whoRefusesIsQuotedAndWhoIsAskedForSomethingElseToo() {
    camera(PICTURES);
    receive("cam", "smell");
    run(1);
    assertThat(ends.get(0).orElseThrow()).contains("smell");
    assertThat(received).isEmpty();
  }

  @Test
  void aRecordingIsPlayedAgainAtItsOwnPace() {
    camera(PICTURES);
    StreamReceiver first = receive("cam", "film");
    run(1);
    first.close();
    run(1);
    Path file = directory.resolve("film.jsonl");
    try (RecordingWriter writer = RecordingWriter.create(file)) {
      received.forEach(one -> writer.add(one.frame(), clock.instant()));
    }
    List<StreamReceiver.Received> live = List.copyOf(received);
    received.clear();

    Recording recording = Recording.read(file);
    member("player", "replay", new Replay(recording, "player", clock));
    run(1);
    receiveAgain();
    run(3);

    assertThat(received.stream().map(one -> one.frame().number()))
        .containsExactlyElementsOf(live.stream().map(one -> one.frame().number()).toList());
    for (int i = 0; i < live.size(); i++) {
      assertThat(received.get(i).frame().data()).isEqualTo(live.get(i).frame().data());
      assertThat(sinceFirst(received, i)).isEqualTo(sinceFirst(live, i));
    }
    assertThat(ends).endsWith(Optional.empty());
  }

  private void receiveAgain() {
    StreamReceiver.open(
        new StreamReceiver.Wanted("player", "replay", Map.of()),
        "other-screen",
        "home",
        bus.client("other-screen"),
        clock,
        SiteKind.OPEN,
        new Screen());
  }

  private static Duration sinceFirst(List<StreamReceiver.Received> all, int one) {
    Instant first = all.get(0).frame().capturedAt();
    return Duration.between(first, all.get(one).frame().capturedAt());
  }

  @Test
  void aFileThatIsNoRecordingIsRefusedInASentence() throws IOException {
    Path file = directory.resolve("wrong.jsonl");
    Files.writeString(file, "{\"v\":\"1.4\"}\n");
    assertThatThrownBy(() -> Recording.read(file))
        .isInstanceOf(RecordingException.class)
        .hasMessageStartingWith("Line 1 of the recording " + file + " is no frame of a stream: ")
        .hasMessageContaining("id must be");
    assertThatThrownBy(() -> RecordingWriter.create(file))
        .hasMessage("There is a file %s already; name another, or remove it.", file);
    Files.writeString(file, "");
    assertThatThrownBy(() -> Recording.read(file)).hasMessageContaining("is empty");
  }

  @Test
  void aFrameThatNoMessageHoldsIsGivenUp() {
    StreamFrame tooLong =
        new StreamFrame(
            "c1", "cam", "film", 1, Instant.EPOCH, PICTURES, new byte[StreamFrame.MOST_BYTES + 1]);
    assertThatThrownBy(() -> new WireFormat().encode(tooLong))
        .hasMessage("A frame of 190001 bytes is more than the 190000 that a message holds");
    StreamFrame longest =
        new StreamFrame(
            "c1", "cam", "film", 1, Instant.EPOCH, PICTURES, new byte[StreamFrame.MOST_BYTES]);
    WireFormat wire = new WireFormat();
    assertThat(wire.decodeFrame(wire.encode(longest)).data()).hasSize(StreamFrame.MOST_BYTES);
  }

  /** Keeps what it is told. */
  private final class Screen implements StreamReceiver.Listener {
    @Override
    public void began() {
      hasBegun = true;
    }

    @Override
    public void received(StreamReceiver.Received one) {
      received.add(one);
      figures.add(one);
    }

    @Override
    public void ended(Optional<String> reason) {
      ends.add(reason);
    }
  }
}
