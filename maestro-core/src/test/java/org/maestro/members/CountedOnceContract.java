package org.maestro.members;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Queue;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * A vat that is filled by 20 with each call, and tells how full it is before its result, after it,
 * never, twice, late, or only what it was before. What it tells and what its results teach come to
 * the knowledge on two ways, in any order between them. However that falls out, what is known is
 * what is in the vat, and what is called its own word is true.
 */
abstract class CountedOnceContract {

  static final int MOST_SEEDS = 1_000;

  /** The client that publishes what the vats tell; their results leave by another. */
  static final String STATES = "states";

  private static final String SITE = "counted";
  private static final String ID = "vat";
  private static final double SHARE = 20;
  private static final Expression.Fluent STOCK =
      new Expression.Fluent("stock", List.of(new Term.Name(ID)));
  private static final Home HOME = home();

  private final Topics topics = new Topics(SITE);
  private final AtomicInteger statesTold = new AtomicInteger();
  private final WireFormat wire = new WireFormat();

  abstract Clock clock();

  abstract Transport client(String id);

  abstract void await(BooleanSupplier condition);

  /** A state is about to be published, by a client called {@link #STATES}. */
  void aStateLeaves() {}

  /** How many seeds are tried each time. */
  abstract int usualSeeds();

  @Test
  void whateverTheOrderAnEffectIsCountedOnce() {
    tryAll(usualSeeds());
  }

  @Test
  @Tag("full")
  void inAThousandOrdersAnEffectIsCountedOnce() {
    tryAll(MOST_SEEDS);
  }

  private void tryAll(int seeds) {
    Transport states = client(STATES);
    Transport vats = client("vats");
    AtomicReference<Vat> present = new AtomicReference<>();
    vats.subscribe(
        topics.calls(),
        Transport.RetainedMessages.IGNORE,
        message -> {
          Call call = wire.decodeCall(message.payload());
          if (call.feature().equals("fill")) {
            present.get().called(call.id());
          } else if (call.feature().equals("$describe") && call.member().isPresent()) {
            present.get().asked();
          }
        });
    Connection connection = new Connection();
    vats.open(Optional.empty(), connection);
    await(() -> connection.isThere);
    Connection other = new Connection();
    states.open(Optional.empty(), other);
    await(() -> other.isThere);
    try (BusLink link = BusLink.connect("cca", SITE, client("cca"), clock())) {
      beSeen(link, new Vat(-1, vats, states));
      for (int seed = 0; seed < seeds; seed++) {
        Vat vat = new Vat(seed, vats, states);
        present.set(vat);
        try (KnowledgeBase knowledge = new CollectiveKnowledge(HOME, clock())) {
          new Trial(vat, link, knowledge).run();
        }
      }
    } finally {
      vats.close();
      states.close();
    }
  }

  /** From then on the link hears each message once. */
  private void beSeen(RatsLink link, Vat first) {
    first.appears();
    await(() -> link.members().stream().anyMatch(member -> member.state().isPresent()));
    first.tell(1);
    await(
        () ->
            link.members().stream()
                .flatMap(member -> member.state().stream())
                .anyMatch(state -> state.values().contains(Vat.fact(1))));
    statesTold.set((int) link.members().iterator().next().statesHeard());
  }

  private static final class Connection implements Transport.ConnectionListener {
    private volatile boolean isThere;

    @Override
    public void connected() {
      isThere = true;
    }

    @Override
    public void lost(String reason) {}
  }

  /** One vat, filled some times. */
  private final class Trial {
    private final Vat vat;
    private final RatsLink link;
    private final Random random;
    private final KnowledgeBase knowledge;
    private final MemberView view;
    private final MemberNews news;
    private final MemberOrders orders;
    private final Queue<Runnable> said = new ArrayDeque<>();
    private final Queue<Runnable> reported = new ArrayDeque<>();
    private final StringBuffer heard = new StringBuffer();
    private volatile long statesHeard;
    private volatile int asked;
    private int calls;

    Trial(Vat vat, RatsLink link, KnowledgeBase knowledge) {
      this.vat = vat;
      this.link = link;
      this.random = vat.random;
      this.knowledge = knowledge;
      this.view =
          new MemberView(
              vat.boot,
              () -> {
                asked++;
                link.describe(ID);
              });
      this.orders = new MemberOrders(ID, link, view, this::inTurn, clock(), new Ear()::said);
      this.news =
          new MemberNews(ID, view, (text, speaker) -> HOME.devices().get(speaker), new Ear());
    }

    void run() {
      Runnable unwatch =
          link.watch(
              ID,
              member -> {
                if (member.boot().equals(vat.boot)) {
                  inTurn(() -> heard(member));
                }
              });

      vat.appears();
      await(() -> view.isReady() && statesHeard == statesTold.get());
      comeToBeKnown(said.size());
      int steps = 1 + random.nextInt(3);
      for (int step = 0; step < steps; step++) {
        int atOnce = random.nextInt(8) == 0 ? 2 : 1;
        int before = reportCount();
        vat.expects(atOnce);
        for (int i = 0; i < atOnce; i++) {
          fill(knowledge.snapshot());
        }
        int reports = before + atOnce;
        await(
            () ->
                !vat.isBusy
                    && reportCount() == reports
                    && asked <= vat.timesAsked
                    && statesHeard == statesTold.get());
        comeToBeKnown(random.nextBoolean() ? said.size() : random.nextInt(said.size() + 1));
        if (said.isEmpty()) {
          check();
        }
      }
      comeToBeKnown(said.size());
      check();
      unwatch.run();
    }

    /** On the link's thread and on the clock's, as the worker of a member is one only. */
    private synchronized void inTurn(Runnable action) {
      action.run();
    }

    private void heard(RatsLink.Member member) {
      news.changed(member);
      if (statesHeard != member.statesHeard()) {
        member.state().ifPresent(state -> heard.append(" ").append(state.values()));
      }
      statesHeard = member.statesHeard();
    }

    private synchronized int reportCount() {
      return reported.size() + learnt;
    }

    private int learnt;

    /** All results, and so many of the words; each way keeps its order. */
    private synchronized void comeToBeKnown(int words) {
      int left = words;
      while (left > 0 || !reported.isEmpty()) {
        boolean word = left > 0 && (reported.isEmpty() || random.nextBoolean());
        (word ? said : reported).remove().run();
        left -= word ? 1 : 0;
        learnt += word ? 0 : 1;
      }
    }

    private void fill(Snapshot before) {
      String conversation = "c" + ++calls;
      clock()
          .schedule(
              Duration.ZERO,
              "test",
              () -> {
                orders.begin(
                    new MemberOrders.Order(
                        FILL,
                        Map.of(),
                        Duration.ofMinutes(5),
                        Optional.of(vat.boot + "-" + conversation),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        false),
                    new Report(conversation, before));
              });
    }

    private void check() {
      OptionalDouble known = knowledge.snapshot().number(STOCK);
      Optional<Belief> belief = knowledge.snapshot().belief(STOCK);
      String what = vat + "; heard was" + heard + "; believed is " + belief;
      if (vat.isAsDescribed && !vat.wasFilledTwiceAtOnce) {
        assertThat(known).as(what).hasValue(vat.content);
      }
      if (belief.filter(b -> b.source().kind() == Source.Kind.STATED).isPresent()) {
        assertThat(known).as("its own word: " + what).hasValue(vat.content);
      }
      if (vat.toldAfterItsResult) {
        assertThat(known).as("its last word: " + what).hasValue(vat.content);
      }
    }

    private final class Ear implements MemberNews.Listener {
      @Override
      public void described(String description) {}

      @Override
      public void said(MemberWord word) {
        synchronized (Trial.this) {
          said.add(() -> knowledge.state(ID, word));
        }
      }

      @Override
      public void lost(String reason) {}
    }

    private final class Report implements CallReporter.Listener {
      private final String conversation;
      private final Snapshot before;

      Report(String conversation, Snapshot before) {
        this.conversation = conversation;
        this.before = before;
      }

      @Override
      public void reported(Outcome outcome, ActionDispatcher.Report report) {
        heard.append(" result of ").append(conversation);
        FeatureRun run =
            new FeatureRun(
                ID,
                FILL,
                Map.of(),
                report.succeeded(),
                report.outputs(),
                report.refs(),
                Optional.of(before),
                true,
                report.account());
        synchronized (Trial.this) {
          reported.add(() -> knowledge.learn(run));
        }
      }

      @Override
      public void learnt(Map<String, Term> outputs) {}

      @Override
      public void over() {}
    }
  }

  /** The device, with all that its maker may have made of the order of its messages. */
  private final class Vat {
    private final String boot;
    private final Random random;
    private final Transport results;
    private final Transport states;
    private final List<String> calls = Collections.synchronizedList(new ArrayList<>());
    private final Set<String> ended = new LinkedHashSet<>();
    private final StringBuilder doings = new StringBuilder();
    private final boolean isAsDescribed;
    private final boolean tellsWhatIsOver;
    private volatile double content;
    private volatile boolean wasFilledTwiceAtOnce;
    private volatile boolean toldAfterItsResult;
    private volatile boolean isBusy;
    private volatile int timesAsked;
    private boolean owesAWord;
    private int expected;

    Vat(int seed, Transport results, Transport states) {
      this.boot = "seed-" + seed;
      this.random = new Random(seed);
      this.results = results;
      this.states = states;
      this.isAsDescribed = random.nextInt(4) > 0;
      this.tellsWhatIsOver = random.nextInt(4) == 0;
      this.content = random.nextInt(3) * SHARE;
    }

    void appears() {
      publish(topics.description(ID), boot.getBytes(UTF_8));
      tell(content);
      publish(topics.status(ID), wire.encode(new MemberStatus(ID, MemberStatus.Phase.READY, boot)));
    }

    void expects(int atOnce) {
      isBusy = true;
      expected = atOnce;
      wasFilledTwiceAtOnce |= atOnce > 1;
    }

    void asked() {
      doings.append(" is asked,");
      toldAfterItsResult = true;
      tell(content);
      timesAsked++;
    }

    /** Does what it was called for when all calls are there. */
    void called(String call) {
      calls.add(call);
      if (calls.size() < expected) {
        return;
      }
      toldAfterItsResult = false;
      if (owesAWord) {
        tell(content);
        owesAWord = false;
      }
      Collections.shuffle(calls, random);
      List.copyOf(calls).forEach(this::fill);
      List<String> over = List.copyOf(calls);
      calls.clear();
      for (String each : over) {
        answer(each);
      }
      for (int words = random.nextInt(3); words > 0; words--) {
        tell(content);
        toldAfterItsResult = true;
      }
      owesAWord = random.nextInt(4) == 0;
      isBusy = false;
    }

    private void fill(String call) {
      maybe(() -> tell(content));
      double amount = isAsDescribed ? SHARE : random.nextInt(5) * 6;
      maybe(() -> tell(content + amount / 4));
      content += amount;
      doings.append(" +").append(amount);
      maybe(() -> ended.add(call));
      maybe(() -> tell(content));
      maybe(() -> tell(content));
      if (calls.size() == 1) {
        return;
      }
      maybe(() -> answer(call));
    }

    private void maybe(Runnable action) {
      if (random.nextInt(3) == 0) {
        action.run();
      }
    }

    private void answer(String call) {
      doings.append(" result");
      ended.add(call);
      String text =
          """
          {"v":"1.0","id":"%s","from":"%s","outcome":"SUCCEEDED","z":"standby","values":{}}\
          """
              .formatted(call, ID);
      for (int times = 1 + random.nextInt(2); times > 0; times--) {
        results.publish(
            Publication.reliable(topics.result("cca", ID), text.getBytes(UTF_8), Optional.empty()),
            failure -> {});
      }
    }

    private void tell(double stock) {
      doings.append(" tells ").append(stock);
      statesTold.incrementAndGet();
      String over =
          ended.stream()
              .map(call -> "{\"id\":\"" + call + "\",\"outcome\":\"SUCCEEDED\"}")
              .reduce((one, other) -> one + "," + other)
              .map(list -> ",\"recent\":[" + list + "]")
              .filter(list -> tellsWhatIsOver)
              .orElse("");
      publish(
          topics.state(ID),
          """
          {"v":"1.0","id":"%s","boot":"%s","z":"standby","values":["%s"]%s}\
          """
              .formatted(ID, boot, fact(stock), over)
              .getBytes(UTF_8));
    }

    private static String fact(double stock) {
      return "(= (stock %s) %s)".formatted(ID, stock);
    }

    private void publish(String topic, byte[] payload) {
      aStateLeaves();
      states.publish(Publication.retained(topic, payload), failure -> {});
    }

    @Override
    public String toString() {
      return "%s, as described: %s, tells what is over: %s,%s"
          .formatted(boot, isAsDescribed, tellsWhatIsOver, doings);
    }
  }

  static final FeatureType FILL =
      new FeatureType(
          "fill",
          "https://example.org/fill",
          false,
          "",
          List.of(),
          List.of(),
          List.of(),
          new Formula.And(List.of()),
          SlParser.effect("(increase (stock ?self) 20)", "stock"::equals),
          Optional.empty(),
          false,
          Optional.empty(),
          OptionalDouble.empty(),
          Set.of(),
          List.of(),
          List.of(),
          new Price.Stated(SlParser.expression("1")),
          SlParser.expression("1"),
          Timing.USUAL,
          Reliability.USUAL,
          Optional.empty(),
          "fill",
          Map.of());

  private static Home home() {
    PredicateDeclaration stock =
        new PredicateDeclaration(
            "stock",
            "https://example.org/stock",
            "stock",
            List.of(SlParser.variable("?d - Device")),
            true,
            true,
            false,
            false,
            Optional.empty(),
            Map.of(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty(),
            Optional.empty());
    Individual itself =
        new Individual(ID, "https://example.org/vat", ID, Set.of("Device"), Map.of());
    return new Home(
        "https://example.org/",
        "home",
        new Vocabulary(Map.of(), Map.of("stock", stock), Map.of()),
        Map.of(ID, itself),
        Map.of(ID, new Device(itself, Optional.empty(), Optional.empty(), List.of(), Map.of())));
  }
}
