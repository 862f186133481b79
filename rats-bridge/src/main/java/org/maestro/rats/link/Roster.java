package org.maestro.rats.link;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The members that are there, from what members publish of themselves. Clock thread only, but for
 * {@link #members}.
 */
final class Roster {

  private static final Logger LOG = LoggerFactory.getLogger(Roster.class);

  /** Told after each change. */
  interface Watcher {
    void changed(RatsLink.Member member);

    /**
     * That life of the member is said to be over.
     *
     * @param isAlive to be told once, later, if the answer is true
     * @return whether it is asked itself before that is believed
     */
    boolean asks(String member, String boot, Consumer<Boolean> isAlive);

    /** That life of the member is over, and calls to it with it. */
    void gone(String member, String boot, String why);

    /**
     * It shows up again after the bus was away, or it was said to be gone; what was sent meanwhile
     * may have missed it.
     */
    void returned(String member);

    /** Something was heard of it, which may not be all. */
    void noticed(String member);
  }

  private final Topics topics;
  private final Watcher watcher;
  private final Complaints complaints;
  private final WireFormat wire = new WireFormat();
  private final Map<String, Entry> entries = new LinkedHashMap<>();
  private final Map<String, RatsLink.Member> members =
      Collections.synchronizedMap(new LinkedHashMap<>());

  Roster(Topics topics, Complaints complaints, Watcher watcher) {
    this.complaints = complaints;
    this.topics = topics;
    this.watcher = watcher;
  }

  /** In the order in which they were first heard of. Any thread. */
  List<RatsLink.Member> members() {
    synchronized (members) {
      return List.copyOf(members.values());
    }
  }

  /** As it is known now. Any thread. */
  Optional<RatsLink.Member> member(String id) {
    return Optional.ofNullable(members.get(id));
  }

  /** The life that the member lives now; empty when it is not ready. */
  Optional<String> readyBoot(String member) {
    return Optional.ofNullable(entries.get(member))
        .filter(entry -> entry.phase.filter(MemberStatus.Phase.READY::equals).isPresent())
        .map(entry -> entry.boot);
  }

  /** Whether all is known of the member that is needed to use it; of who is gone, nothing is. */
  MissingWords.Known known(String member) {
    Entry entry = entries.get(member);
    if (entry == null || entry.isSaidToBeGone()) {
      return MissingWords.Known.NOTHING;
    }
    return entry.isComplete() ? MissingWords.Known.ENOUGH : MissingWords.Known.A_PART;
  }

  void statusHeard(Message message) {
    sender(message)
        .ifPresent(
            id -> {
              if (message.payload().length == 0) {
                cleared(id);
              } else {
                decoded(message, () -> wire.decodeStatus(message.payload()))
                    .filter(status -> isOwn(id, status.member(), message))
                    .ifPresent(this::status);
              }
            });
  }

  void descriptionHeard(Message message) {
    sender(message)
        .ifPresent(
            id -> {
              boolean clearing = message.payload().length == 0;
              if (clearing && !entries.containsKey(id) || isTooLong(message)) {
                return;
              }
              Entry entry = entry(id);
              entry.description =
                  clearing ? Optional.empty() : Optional.of(new String(message.payload(), UTF_8));
              publish(entry);
            });
  }

  void stateHeard(Message message) {
    sender(message)
        .ifPresent(
            id -> {
              if (message.payload().length == 0) {
                Optional.ofNullable(entries.get(id))
                    .filter(entry -> entry.state.isPresent())
                    .ifPresent(entry -> states(entry, Optional.empty()));
              } else {
                decoded(message, () -> wire.decodeState(message.payload()))
                    .filter(state -> isOwn(id, state.member(), message))
                    .filter(state -> !isToldAgain(entry(id), state))
                    .ifPresent(state -> states(entry(id), Optional.of(state)));
              }
            });
  }

  /** What a broker has kept, and sends once more after a connect, was not said since. */
  private static boolean isToldAgain(Entry entry, MemberState state) {
    boolean isKept = entry.awaitsKept && entry.state.equals(Optional.of(state));
    entry.awaitsKept = false;
    return isKept;
  }

  private void states(Entry entry, Optional<MemberState> state) {
    entry.state = state;
    entry.statesHeard++;
    publish(entry);
  }

  /** From now on only those count as there whose status is heard again. */
  void doubtAll() {
    entries
        .values()
        .forEach(
            entry -> {
              entry.doubted = true;
              entry.awaitsKept = true;
              entry.settle();
            });
  }

  /** Takes those for lost that were doubted and did not show up. */
  void dropDoubted() {
    for (Entry entry : new ArrayList<>(entries.values())) {
      if (entry.doubted && entry.present()) {
        entry.doubted = false;
        entry.settle();
        entry.phase = Optional.of(MemberStatus.Phase.LOST);
        publish(entry);
        watcher.gone(entry.id, entry.boot, "it did not come back after the bus did");
      }
    }
  }

  private void status(MemberStatus status) {
    Entry entry = entry(status.member());
    boolean otherLife = entry.present() && !entry.boot.equals(status.boot());
    boolean leaves = leaves(status);
    boolean saidToLive =
        entry.unproven.filter(latest -> latest.boot().equals(status.boot())).isPresent();
    if (leaves && otherLife && !saidToLive) {
      entry.doubted = false;
      LOG.debug("{} of a former life of {} is ignored", status.phase(), status.member());
      return;
    }
    boolean endsLife = otherLife || leaves && entry.present();
    hear(entry, new Hearsay(status.boot(), endsLife, () -> believe(entry, status)));
  }

  /**
   * Calls that run are not given up for what somebody says: the latest waits for an answer. Who
   * says that the life goes on may be back just now, and is asked once more.
   */
  private void hear(Entry entry, Hearsay hearsay) {
    boolean isOpen = entry.unproven.isPresent();
    if (!isOpen && !(hearsay.endsLife() && asks(entry))) {
      hearsay.belief().run();
      return;
    }
    entry.unproven = Optional.of(hearsay);
    if (isOpen && !hearsay.endsLife() && !entry.contradicted) {
      entry.contradicted = asks(entry);
    }
  }

  private boolean asks(Entry entry) {
    int question = ++entry.questions;
    return watcher.asks(entry.id, entry.boot, isAlive -> judge(entry, question, isAlive));
  }

  private void judge(Entry entry, int question, boolean isAlive) {
    Optional<Hearsay> heard = entry.unproven;
    if (heard.isEmpty() || entry.questions != question) {
      return;
    }
    entry.settle();
    if (isAlive) {
      entry.doubted = false;
      watcher.returned(entry.id);
      return;
    }
    if (!heard.get().endsLife()) {
      watcher.gone(entry.id, entry.boot, "it gives no answer");
    }
    heard.get().belief().run();
  }

  private void believe(Entry entry, MemberStatus status) {
    boolean otherLife = entry.phase.isPresent() && !entry.boot.equals(status.boot());
    boolean returned = entry.doubted && !leaves(status) && !otherLife;
    boolean known = entry.phase.filter(status.phase()::equals).isPresent() && !otherLife;
    if (known && !entry.doubted) {
      return;
    }
    entry.doubted = false;
    String formerBoot = entry.boot;
    entry.phase = Optional.of(status.phase());
    entry.boot = status.boot();
    if (leaves(status)) {
      // When it is back, it has to say anew how it is.
      entry.state = Optional.empty();
    }
    publish(entry);
    if (otherLife) {
      watcher.gone(status.member(), formerBoot, "it was started again");
    } else if (leaves(status)) {
      watcher.gone(status.member(), status.boot(), "its connection is gone");
    } else if (returned) {
      watcher.returned(status.member());
    }
  }

  private static boolean leaves(MemberStatus status) {
    return status.phase() == MemberStatus.Phase.LOST
        || status.phase() == MemberStatus.Phase.DISCONNECTED;
  }

  private void cleared(String id) {
    Entry entry = entries.get(id);
    if (entry != null && entry.phase.isPresent()) {
      hear(entry, new Hearsay(entry.boot, entry.present(), () -> leave(entry)));
    }
  }

  private void leave(Entry entry) {
    entries.remove(entry.id);
    entry.phase = Optional.of(MemberStatus.Phase.DISCONNECTED);
    members.remove(entry.id);
    watcher.changed(entry.member());
    watcher.gone(entry.id, entry.boot, "it left");
    watcher.noticed(entry.id);
  }

  private void publish(Entry entry) {
    watcher.noticed(entry.id);
    if (entry.phase.isPresent()) {
      RatsLink.Member member = entry.member();
      members.put(entry.id, member);
      watcher.changed(member);
    }
  }

  private Entry entry(String id) {
    return entries.computeIfAbsent(id, Entry::new);
  }

  private Optional<String> sender(Message message) {
    return topics.memberOf(message.topic());
  }

  private boolean isTooLong(Message message) {
    int bytes = message.payload().length;
    if (bytes > WireFormat.MOST_BYTES && complaints.isDue(topics.speakerOf(message.topic()))) {
      LOG.warn(
          "On {}: the payload must be at most {} bytes, but is {} bytes; the message is ignored",
          message.topic(),
          WireFormat.MOST_BYTES,
          bytes);
    }
    return bytes > WireFormat.MOST_BYTES;
  }

  private boolean isOwn(String sender, String member, Message message) {
    if (!sender.equals(member) && complaints.isDue(sender)) {
      LOG.warn("A message of {} on the topic {} is ignored", member, message.topic());
    }
    return sender.equals(member);
  }

  private <T> Optional<T> decoded(Message message, Supplier<T> decoder) {
    try {
      return Optional.of(decoder.get());
    } catch (MalformedMessageException malformed) {
      if (complaints.isDue(topics.speakerOf(message.topic()))) {
        LOG.warn("On {}: {}; the message is ignored", message.topic(), malformed.getMessage());
      }
      return Optional.empty();
    }
  }

  /**
   * A statement on the bus about a member's life.
   *
   * @param boot the life that it speaks of
   * @param endsLife whether the one that was known is over then
   */
  private record Hearsay(String boot, boolean endsLife, Runnable belief) {}

  private static final class Entry {
    private final String id;
    private Optional<MemberStatus.Phase> phase = Optional.empty();
    private String boot = "";
    private Optional<String> description = Optional.empty();
    private Optional<MemberState> state = Optional.empty();
    private long statesHeard;
    private boolean doubted;
    private boolean awaitsKept;
    private Optional<Hearsay> unproven = Optional.empty();
    private int questions;
    private boolean contradicted;

    private Entry(String id) {
      this.id = id;
    }

    private boolean present() {
      return phase
          .filter(now -> now == MemberStatus.Phase.READY || now == MemberStatus.Phase.INIT)
          .isPresent();
    }

    /** No answer is waited for any more. */
    private void settle() {
      unproven = Optional.empty();
      contradicted = false;
    }

    private boolean isSaidToBeGone() {
      return phase.isPresent() && !present();
    }

    private boolean isComplete() {
      return phase.filter(MemberStatus.Phase.READY::equals).isPresent()
          && description.isPresent()
          && ownState().isPresent();
    }

    /** Of the life that it lives now. */
    private Optional<MemberState> ownState() {
      return state.filter(known -> known.boot().equals(boot));
    }

    private RatsLink.Member member() {
      return new RatsLink.Member(
          id, phase.orElseThrow(), boot, description, ownState(), statesHeard);
    }
  }
}
