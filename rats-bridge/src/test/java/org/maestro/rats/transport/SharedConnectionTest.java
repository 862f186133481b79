package org.maestro.rats.transport;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.transport.Transport.RetainedMessages;

/** Clients of one connection behave as those do that have one each. */
class SharedConnectionTest extends PahoTransportContract {
  private Optional<SharedConnection> shared = Optional.empty();

  @Override
  TestBroker broker() {
    return TestBroker.embedded();
  }

  @Override
  Transport client(String id) {
    if (shared.isEmpty()) {
      shared =
          Optional.of(
              new SharedConnection(super.client("shared"), "#", List.of("m/#", "n/#", "a/b")));
    }
    return shared.get().client(id);
  }

  @AfterEach
  void closeConnection() {
    shared.ifPresent(SharedConnection::close);
  }

  /** Where others are connected, so is who comes, at once: it is told nothing after its end. */
  @Override
  @Test
  void canBeClosedWhileItConnects() {
    AtomicInteger connected = new AtomicInteger();
    List<String> lost = new ArrayList<>();
    for (int number = 0; number < 10; number++) {
      Transport client = client("hasty-" + number);
      open(client, connected, lost);
      client.close();
    }
    int before = connected.get();
    AtomicInteger patient = new AtomicInteger();
    open(client("patient"), patient, lost);
    await(() -> patient.get() == 1);
    assertThat(connected).hasValue(before);
    assertThat(lost).isEmpty();
  }

  @Test
  void manyHearWhatIsSaidToAllAndEachWhatIsSaidToIt() {
    int clients = 200;
    AtomicInteger connected = new AtomicInteger();
    AtomicInteger ofAll = new AtomicInteger();
    AtomicInteger ofOne = new AtomicInteger();
    List<Transport> opened = new ArrayList<>();
    for (int number = 0; number < clients; number++) {
      Transport client = client("client-" + number);
      client.subscribe("call/#", RetainedMessages.IGNORE, message -> ofAll.incrementAndGet());
      client.subscribe(
          "m/" + number + "/status", RetainedMessages.SEND, message -> ofOne.incrementAndGet());
      open(client, connected, new ArrayList<>());
      opened.add(client);
    }
    await(() -> connected.get() == clients);

    opened
        .get(0)
        .publish(Publication.retained("m/7/status", "ready".getBytes(UTF_8)), ignored -> {});
    opened.get(1).publish(Publication.stream("call/anyone", "x".getBytes(UTF_8)), ignored -> {});

    await(() -> ofAll.get() == clients && ofOne.get() == 1);
    opened.get(7).close();
    opened.get(1).publish(Publication.stream("call/anyone", "y".getBytes(UTF_8)), ignored -> {});
    await(() -> ofAll.get() == 2 * clients - 1);
    assertThat(ofOne).hasValue(1);
  }

  @Test
  void whatItDoesNotHearOfNobodyCanSubscribeTo() {
    SharedConnection ofSite =
        new SharedConnection(super.client("site"), "rats/1/site/#", List.of());
    Transport client = ofSite.client("client");

    assertThatThrownBy(
            () -> client.subscribe("rats/1/other/call/#", RetainedMessages.SEND, m -> {}))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "'rats/1/other/call/#' is not among what this connection hears, 'rats/1/site/#'.");
    client.subscribe("rats/1/site/call/#", RetainedMessages.SEND, m -> {});
    ofSite.close();
  }

  @Test
  void whoFailsDoesNotKeepOthersFromHearing() {
    AtomicInteger heard = new AtomicInteger();
    AtomicInteger connected = new AtomicInteger();
    Transport failing = client("failing");
    failing.subscribe(
        "a/#",
        RetainedMessages.SEND,
        message -> {
          throw new IllegalStateException("as in a test");
        });
    open(failing, connected, new ArrayList<>());
    Transport other = client("other");
    other.subscribe("a/#", RetainedMessages.SEND, message -> heard.incrementAndGet());
    open(other, connected, new ArrayList<>());
    await(() -> connected.get() == 2);

    other.publish(Publication.stream("a/b", new byte[1]), ignored -> {});

    await(() -> heard.get() == 1);
  }

  private static void open(Transport client, AtomicInteger connected, List<String> lost) {
    client.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            connected.incrementAndGet();
          }

          @Override
          public void lost(String reason) {
            lost.add(reason);
          }
        });
  }
}
