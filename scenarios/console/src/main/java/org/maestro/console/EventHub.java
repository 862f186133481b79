package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.console.access.Readership;
import org.maestro.console.documents.FactsDocument;
import org.maestro.console.documents.HomeDocument;
import org.maestro.console.documents.StoryDocument;
import org.maestro.console.questions.Questions;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.ReadingRights;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What happens, told to all who listen: first all that is so, then what changes, gathered for a
 * tenth of a second, so that a thousand changes are one event. As long as nobody listens nothing is
 * looked at. Its own thread does the work; any thread may tell it of something.
 */
final class EventHub implements EventSource, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(EventHub.class);
  private static final long GATHERED_MILLIS = 100;

  /** Agents come and go, and facts grow too old, without a word; so often it is looked for. */
  static final Duration LOOK = Duration.ofSeconds(1);

  /** What goes on by itself is nothing new. */
  private static final List<String> AGES =
      List.of("age_s", "silence_s", "elapsed_s", "urgency", "weight");

  private final Questions questions;
  private final KnowledgeBase knowledge;
  private final Readership readership;
  private final Map<String, Supplier<JsonNode>> looked;
  private final Consumer<Duration> answered;
  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread named = new Thread(task, "console-events");
            named.setDaemon(true);
            return named;
          });
  private final List<Future<?>> rounds = new ArrayList<>();
  private final AtomicBoolean factsAreNew = new AtomicBoolean(true);
  private final AtomicBoolean goalsAreNew = new AtomicBoolean(true);

  // All below is the thread's own.
  private final Listeners listeners = new Listeners();
  private Map<String, Belief> facts = Map.of();
  private int leftOut;
  private Optional<Home> drawn = Optional.empty();
  private Optional<JsonNode> home = Optional.empty();
  private Optional<JsonNode> goals = Optional.empty();
  private Optional<JsonNode> agents = Optional.empty();
  private final Map<String, JsonNode> seen = new HashMap<>();

  /**
   * @param readership all listeners are told the same: what all who look may read
   * @param looked what is looked at again and again, by the name of its event; quickly told
   * @param answered told how long agents take to answer
   */
  EventHub(
      Questions questions,
      KnowledgeBase knowledge,
      Readership readership,
      Map<String, Supplier<JsonNode>> looked,
      Consumer<Duration> answered) {
    this.questions = questions;
    this.knowledge = knowledge;
    this.readership = readership;
    this.looked = looked;
    this.answered = answered;
  }

  void start() {
    knowledge.watch(change -> factsAreNew.set(true));
    rounds.add(everyMillis(GATHERED_MILLIS, this::tell));
    rounds.add(everyMillis(LOOK.toMillis(), this::look));
  }

  private Future<?> everyMillis(long pause, Runnable work) {
    return thread.scheduleWithFixedDelay(() -> guarded(work), pause, pause, TimeUnit.MILLISECONDS);
  }

  @Override
  public void listen(EventQueue listener, Runnable then) {
    later(
        () -> {
          admit(listener);
          then.run();
        });
  }

  private void admit(EventQueue listener) {
    if (listeners.isEmpty()) {
      refresh();
    }
    if (!listeners.admit(listener)) {
      return;
    }
    home.ifPresent(document -> listener.add("home", document));
    listener.add("facts", changes(facts, Set.of(), knowledge.snapshot(), true));
    goals.ifPresent(document -> listener.add("goals", document));
    agents.ifPresent(document -> listener.add("agents", document));
    seen.forEach(listener::add);
  }

  @Override
  public void leave(EventQueue listener) {
    later(() -> listeners.leave(listener));
  }

  /** A sentence of a story; any thread may bring it. */
  void told(StoryEntry entry) {
    goalsAreNew.set(true);
    later(
        () ->
            readership
                .toAll(entry)
                .ifPresent(told -> listeners.tell("story", StoryDocument.of(told))));
  }

  /** After the end nobody is told anything. */
  private void later(Runnable work) {
    try {
      thread.execute(work);
    } catch (RejectedExecutionException e) {
      LOG.debug("Something happened after the console had ended");
    }
  }

  private void refresh() {
    drawn = Optional.of(knowledge.home());
    home = drawn.map(HomeDocument::of);
    facts = told(knowledge.snapshot());
    goalsAreNew.set(true);
    looked.forEach((name, look) -> seen.put(name, look.get()));
    askForAgents();
  }

  private Map<String, Belief> told(Snapshot snapshot) {
    ReadingRights rights = readership.ofAll();
    List<Belief> all = snapshot.beliefs();
    Map<String, Belief> byFact = new LinkedHashMap<>();
    all.stream()
        .filter(belief -> rights.mayReadFact(belief.fact()))
        .forEach(belief -> byFact.put(belief.fact(), belief));
    leftOut = all.size() - byFact.size();
    return byFact;
  }

  private void tell() {
    if (listeners.isEmpty()) {
      return;
    }
    if (factsAreNew.getAndSet(false)) {
      tellFacts();
    }
    if (goalsAreNew.getAndSet(false)) {
      questions
          .goals()
          .thenAcceptAsync(
              document -> {
                goals = Optional.of(document);
                listeners.tell("goals", document);
              },
              thread)
          .exceptionally(
              failure -> {
                // Without a coordinator there is none to tell; it is asked again soon.
                goalsAreNew.set(true);
                return null;
              });
    }
  }

  private void tellFacts() {
    Snapshot snapshot = knowledge.snapshot();
    int leftOutBefore = leftOut;
    Map<String, Belief> now = told(snapshot);
    Map<String, Belief> changed = new LinkedHashMap<>(now);
    changed.entrySet().removeIf(entry -> entry.getValue().equals(facts.get(entry.getKey())));
    Set<String> gone = new HashSet<>(facts.keySet());
    gone.removeAll(now.keySet());
    facts = now;
    if (!changed.isEmpty() || !gone.isEmpty() || leftOut != leftOutBefore) {
      listeners.tell("facts", changes(changed, gone, snapshot, false));
    }
    tellHome(knowledge.home());
  }

  /** A home is another one when something in it is. */
  private void tellHome(Home now) {
    if (drawn.equals(Optional.of(now))) {
      return;
    }
    drawn = Optional.of(now);
    JsonNode document = HomeDocument.of(now);
    if (!Optional.of(document).equals(home)) {
      home = Optional.of(document);
      listeners.tell("home", document);
    }
  }

  private JsonNode changes(
      Map<String, Belief> set, Set<String> gone, Snapshot snapshot, boolean all) {
    ObjectNode node =
        JsonNodeFactory.instance.objectNode().put("all", all).put("left_out", leftOut);
    ArrayNode facts = node.putArray("facts");
    set.values().forEach(belief -> facts.add(FactsDocument.of(belief, snapshot)));
    ArrayNode lost = node.putArray("gone");
    gone.forEach(lost::add);
    return node;
  }

  private void look() {
    factsAreNew.set(true);
    askForAgents();
    if (!listeners.isEmpty()) {
      looked.forEach((name, look) -> tellSeen(name, look.get()));
    }
  }

  private void tellSeen(String name, JsonNode now) {
    Optional<JsonNode> before = Optional.ofNullable(seen.put(name, now));
    if (before.filter(then -> withoutAges(then).equals(withoutAges(now))).isEmpty()) {
      listeners.tell(name, now);
    }
  }

  private void askForAgents() {
    if (listeners.isEmpty() && agents.isPresent()) {
      return;
    }
    long asked = System.nanoTime();
    questions
        .agents()
        .thenAcceptAsync(
            document -> {
              answered.accept(Duration.ofNanos(System.nanoTime() - asked));
              if (agents
                  .filter(before -> withoutAges(before).equals(withoutAges(document)))
                  .isEmpty()) {
                listeners.tell("agents", document);
              }
              agents = Optional.of(document);
            },
            thread)
        .exceptionally(failure -> null);
  }

  private static JsonNode withoutAges(JsonNode document) {
    JsonNode copy = document.deepCopy();
    for (String age : AGES) {
      copy.findParents(age).forEach(row -> ((ObjectNode) row).remove(age));
    }
    return copy;
  }

  /** Who has thrown once is asked again all the same. */
  private static void guarded(Runnable work) {
    try {
      work.run();
    } catch (RuntimeException e) {
      LOG.error("What happens could not be told to the console's listeners", e);
    }
  }

  @Override
  public void close() {
    rounds.forEach(round -> round.cancel(false));
    thread.shutdownNow();
  }
}
