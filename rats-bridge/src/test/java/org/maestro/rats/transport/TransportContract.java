package org.maestro.rats.transport;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.transport.Transport.RetainedMessages;

/** What every transport must do; run over each of them. */
abstract class TransportContract {

  private final List<Transport> opened = new ArrayList<>();

  /** A transport that is not open yet. */
  abstract Transport client(String id);

  abstract void stopBroker();

  abstract void restartBroker();

  /** Waits until the condition holds, at most some seconds, and fails if it does not. */
  abstract void await(BooleanSupplier condition);

  @AfterEach
  void closeAll() {
    opened.forEach(Transport::close);
  }

  @Test
  void deliversToEverySubscriberInOrder() {
    Inbox first = new Inbox();
    Inbox second = new Inbox();
    open("first", first, "site/call/#", RetainedMessages.SEND);
    open("second", second, "site/+/cca", RetainedMessages.SEND);
    Transport publisher = open("publisher");
    for (int number = 0; number < 200; number++) {
      publisher.publish(reliable("site/call/cca", "n" + number), failure -> {});
    }
    await(() -> first.size() == 200 && second.size() == 200);
    for (int number = 0; number < 200; number++) {
      assertThat(first.text(number)).isEqualTo("site/call/cca=n" + number);
      assertThat(second.text(number)).isEqualTo("site/call/cca=n" + number);
    }
    assertThat(first.messages.get(0).retained()).isFalse();
  }

  @Test
  void tellsTheCompletionOfEachPublishOnce() {
    Transport publisher = open("publisher");
    List<Optional<PublishException>> completions = new CopyOnWriteArrayList<>();
    for (int number = 0; number < 300; number++) {
      publisher.publish(reliable("a/b", "x"), completions::add);
      publisher.publish(Publication.stream("a/c", bytes("y")), completions::add);
    }
    await(() -> completions.size() == 600);
    assertThat(completions).allMatch(Optional::isEmpty);
  }

  @Test
  void keepsRetainedMessagesAndSendsThemToWhomWantsThem() {
    Transport publisher = open("publisher");
    Inbox hearing = new Inbox();
    open("hearing", hearing, "m/#", RetainedMessages.IGNORE);
    publish(publisher, Publication.retained("m/rose/status", bytes("ready")));
    publish(publisher, Publication.retained("m/rose/state", bytes("standby")));
    publish(publisher, Publication.clearing("m/rose/state"));
    // A connection that is shared tells what it has heard, which the broker may have acknowledged
    // before.
    await(() -> hearing.size() == 3);
    Inbox wanting = new Inbox();
    Inbox ignoring = new Inbox();
    open("ignoring", ignoring, "m/rose/status", RetainedMessages.IGNORE);
    open("wanting", wanting, "m/#", RetainedMessages.SEND);
    await(() -> wanting.size() == 1);
    assertThat(wanting.text(0)).isEqualTo("m/rose/status=ready");
    assertThat(wanting.messages.get(0).retained()).isTrue();
    assertThat(ignoring.messages).isEmpty();
    publish(publisher, Publication.retained("m/rose/status", bytes("again")));
    await(() -> wanting.size() == 2 && ignoring.size() == 1);
    assertThat(ignoring.messages.get(0).retained())
        .as("the flag is delivered as it was published")
        .isTrue();
  }

  @Test
  void sendsWhatIsRetainedOnceMoreToWhoAsks() {
    Transport publisher = open("publisher");
    publish(publisher, Publication.retained("m/rose/status", bytes("ready")));
    Inbox inbox = new Inbox();
    Inbox ignored = new Inbox();
    Transport wanting = client("wanting");
    wanting.subscribe("m/#", RetainedMessages.SEND, inbox);
    wanting.subscribe("n/#", RetainedMessages.IGNORE, ignored);
    open(wanting, Optional.empty());
    await(() -> inbox.size() == 1);
    publish(publisher, Publication.retained("n/rose", bytes("kept")));
    await(() -> ignored.size() == 1);
    wanting.askForRetained("m/#");
    wanting.askForRetained("n/#");
    wanting.askForRetained("never/subscribed");
    await(() -> inbox.size() == 2);
    publish(publisher, reliable("m/rose/state", "moving"));
    publish(publisher, reliable("n/rose", "once"));
    await(() -> inbox.size() >= 3 && ignored.size() >= 2);
    assertThat(inbox.text(1)).isEqualTo("m/rose/status=ready");
    assertThat(inbox.text(2)).isEqualTo("m/rose/state=moving");
    assertThat(ignored.text(1)).as("no retained one, as it wanted").isEqualTo("n/rose=once");
  }

  @Test
  void deliversWhatOthersSayToWhomWantsOnlyThat() {
    Inbox inbox = new Inbox();
    Transport own = client("own");
    own.subscribeToOthers("site/call/#", inbox);
    open(own, Optional.empty());
    Transport other = open("other");
    publish(own, reliable("site/call/own", "mine"));
    publish(other, reliable("site/call/other", "theirs"));
    await(() -> inbox.size() == 1);
    publish(own, reliable("site/call/own", "mine again"));
    publish(other, reliable("site/call/other", "theirs again"));
    await(() -> inbox.size() == 2);
    assertThat(inbox.text(0)).isEqualTo("site/call/other=theirs");
    assertThat(inbox.text(1)).isEqualTo("site/call/other=theirs again");
  }

  @Test
  void tellsWhatIsLeftOfTheExpiry() {
    Inbox inbox = new Inbox();
    open("reader", inbox, "a/#", RetainedMessages.SEND);
    Transport publisher = open("publisher");
    publish(
        publisher, Publication.reliable("a/b", bytes("x"), Optional.of(Duration.ofMillis(29_500))));
    publish(publisher, reliable("a/b", "y"));
    await(() -> inbox.size() == 2);
    assertThat(inbox.messages.get(0).remainingExpiry().orElseThrow())
        .isBetween(Duration.ofSeconds(25), Duration.ofSeconds(30));
    assertThat(inbox.messages.get(1).remainingExpiry()).isEmpty();
  }

  @Test
  void publishesTheWillOfAClientThatDiesOnly() {
    Inbox inbox = new Inbox();
    open("reader", inbox, "m/+/status", RetainedMessages.SEND);
    Transport polite = client("polite");
    Transport mortal = client("mortal");
    open(polite, Optional.of(new Transport.Will("m/polite/status", bytes("lost"))));
    open(mortal, Optional.of(new Transport.Will("m/mortal/status", bytes("lost"))));
    polite.publish(Publication.retained("m/polite/status", bytes("disconnected")), failure -> {});
    polite.close();
    await(() -> inbox.size() == 1);
    mortal.die();
    await(() -> inbox.size() == 2);
    assertThat(inbox.text(0)).isEqualTo("m/polite/status=disconnected");
    assertThat(inbox.text(1)).isEqualTo("m/mortal/status=lost");
    Inbox later = new Inbox();
    open("late", later, "m/mortal/#", RetainedMessages.SEND);
    await(() -> later.size() == 1);
    assertThat(later.messages.get(0).retained()).isTrue();
  }

  @Test
  void whoLeavesAndIsClosedAtOnceHasNotDied() {
    Inbox inbox = new Inbox();
    Transport reader = client("reader");
    reader.subscribe("m/+/status", RetainedMessages.SEND, inbox);
    open(reader, Optional.empty());
    for (int number = 0; number < 20; number++) {
      Transport guest = client("guest-" + number);
      open(guest, Optional.of(new Transport.Will("m/guest-" + number + "/status", bytes("lost"))));
      guest.leave();
      guest.close();
    }
    publish(reader, Publication.retained("m/end/status", bytes("end")));
    await(() -> inbox.size() >= 1);
    assertThat(inbox.messages).hasSize(1);
  }

  @Test
  void staysAwayForAWhileAndSaysGoodbyeBefore() {
    Inbox wills = new Inbox();
    open("reader", wills, "m/+/status", RetainedMessages.SEND);
    Inbox inbox = new Inbox();
    Listener listener = new Listener();
    Transport client = client("guest");
    client.subscribe("a/#", RetainedMessages.SEND, inbox);
    opened.add(client);
    client.open(Optional.of(new Transport.Will("m/guest/status", bytes("lost"))), listener);
    await(() -> listener.connectedTimes() == 1);
    client.stayAway(Duration.ofMillis(500));
    List<Optional<PublishException>> completions = new CopyOnWriteArrayList<>();
    client.publish(reliable("a/b", "meanwhile"), completions::add);
    await(() -> completions.size() == 1 && completions.get(0).isPresent());
    await(() -> listener.connectedTimes() == 2);
    publish(client, reliable("a/b", "again"));
    await(() -> inbox.size() == 1);
    assertThat(inbox.text(0)).isEqualTo("a/b=again");
    assertThat(listener.events).containsExactly("connected", "connected");
    assertThat(wills.messages).isEmpty();
  }

  @Test
  void subscribesWhileItIsOpen() {
    Transport publisher = open("publisher");
    publish(publisher, Publication.retained("a/b", bytes("kept")));
    Transport reader = open("reader");
    Inbox inbox = new Inbox();
    reader.subscribe("a/b", RetainedMessages.SEND, inbox);
    await(() -> inbox.size() == 1);
  }

  @Test
  void reconnectsToABrokerThatCameBackEmpty() {
    Inbox inbox = new Inbox();
    Listener listener = new Listener();
    Transport client = client("client");
    client.subscribe("a/#", RetainedMessages.SEND, inbox);
    opened.add(client);
    client.open(Optional.empty(), listener);
    await(() -> listener.events.size() == 1);
    publish(client, Publication.retained("a/b", bytes("kept")));
    await(() -> inbox.size() == 1);
    stopBroker();
    await(() -> listener.events.size() >= 2);
    List<Optional<PublishException>> completions = new CopyOnWriteArrayList<>();
    client.publish(reliable("a/b", "x"), completions::add);
    await(() -> completions.size() == 1);
    assertThat(completions.get(0).orElseThrow()).hasMessageContaining("a/b");
    restartBroker();
    await(() -> listener.connectedTimes() == 2);
    publish(client, reliable("a/c", "again"));
    await(() -> inbox.size() == 2);
    assertThat(inbox.text(1)).isEqualTo("a/c=again");
  }

  @Test
  void refusesToPublishOnceClosed() {
    Transport client = open("client");
    client.close();
    client.close();
    List<Optional<PublishException>> completions = new CopyOnWriteArrayList<>();
    client.publish(reliable("a/b", "x"), completions::add);
    await(() -> completions.size() == 1);
    assertThat(completions.get(0)).isPresent();
  }

  @Test
  void canBeClosedWhileItConnects() {
    Listener listener = new Listener();
    for (int number = 0; number < 10; number++) {
      Transport client = client("hasty-" + number);
      client.open(Optional.empty(), listener);
      if (number % 2 == 0) {
        client.close();
      } else {
        client.die();
      }
    }
    open("patient");
    assertThat(listener.events).isEmpty();
  }

  @Test
  void refusesWhatIsNoFilter() {
    Transport client = client("client");
    for (String text : List.of("", "a/#/b", "a+/b", "a/b#")) {
      assertThatThrownBy(() -> client.subscribe(text, RetainedMessages.SEND, message -> {}))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("topic filter");
    }
    client.close();
  }

  private Transport open(String id) {
    Transport client = client(id);
    open(client, Optional.empty());
    return client;
  }

  private void open(String id, Inbox inbox, String filter, RetainedMessages retained) {
    Transport client = client(id);
    client.subscribe(filter, retained, inbox);
    open(client, Optional.empty());
  }

  private void open(Transport client, Optional<Transport.Will> will) {
    opened.add(client);
    Listener listener = new Listener();
    client.open(will, listener);
    await(() -> listener.connectedTimes() == 1);
  }

  private void publish(Transport client, Publication publication) {
    List<Optional<PublishException>> completions = new CopyOnWriteArrayList<>();
    client.publish(publication, completions::add);
    await(() -> completions.size() == 1);
    assertThat(completions.get(0)).isEmpty();
  }

  private static Publication reliable(String topic, String text) {
    return Publication.reliable(topic, bytes(text), Optional.empty());
  }

  private static byte[] bytes(String text) {
    return text.getBytes(UTF_8);
  }

  private static final class Inbox implements Transport.MessageHandler {
    private final List<Message> messages = new CopyOnWriteArrayList<>();

    @Override
    public void arrived(Message message) {
      messages.add(message);
    }

    int size() {
      return messages.size();
    }

    String text(int index) {
      Message message = messages.get(index);
      return message.topic() + "=" + new String(message.payload(), UTF_8);
    }
  }

  private static final class Listener implements Transport.ConnectionListener {
    private final List<String> events = new CopyOnWriteArrayList<>();

    @Override
    public void connected() {
      events.add("connected");
    }

    @Override
    public void lost(String reason) {
      events.add("lost: " + reason);
    }

    long connectedTimes() {
      return events.stream().filter("connected"::equals).count();
    }
  }
}
