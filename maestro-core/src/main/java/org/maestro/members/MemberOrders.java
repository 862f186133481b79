package org.maestro.members;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Term;

/**
 * Orders to one member, and questions for its prices: they become calls over the link, and what
 * becomes of those is reported with the account of what the member said of itself around it. For
 * the worker's thread only, on which everything is told, too.
 */
public final class MemberOrders {
  /**
   * Who tells that a call is over has told so by then: the broker may hand it on a little later.
   */
  private static final Duration STATE_COMES = Duration.ofMillis(100);

  /** Who is asked once more what it says of itself is waited for so long. */
  private static final Duration ANSWER_COMES = Duration.ofSeconds(2);

  private final String member;
  private final RatsLink link;
  private final MemberView view;
  private final Executor worker;
  private final Clock clock;
  private final Consumer<MemberWord> say;
  private long lastOrder;

  /**
   * @param say tells what the member said of itself while it was called
   */
  public MemberOrders(
      String member,
      RatsLink link,
      MemberView view,
      Executor worker,
      Clock clock,
      Consumer<MemberWord> say) {
    this.member = member;
    this.link = link;
    this.view = view;
    this.worker = worker;
    this.clock = clock;
    this.say = say;
  }

  /**
   * An order: a bound feature that is to be done, or to end.
   *
   * @param call names it for good; empty: it is a new one
   * @param boot the member's life in which it is to be done; empty: whichever it lives
   * @param expects what who orders it counts on
   * @param ends nothing is to be done: the call of that name is to end
   */
  public record Order(
      FeatureType feature,
      Map<String, Argument> arguments,
      Duration timeout,
      Optional<String> call,
      Optional<String> boot,
      Optional<String> goal,
      Optional<Call.Expectation> expects,
      boolean ends) {

    public Map<String, Term> bindings() {
      return valued(arguments, Argument::value);
    }

    private RatsLink.Order to(String member) {
      return new RatsLink.Order(
          call,
          member,
          boot,
          feature.name(),
          json(arguments),
          timeout,
          feature.timing().grace(),
          goal,
          expects);
    }
  }

  public RatsLink.CallHandle begin(Order order, CallReporter.Listener listener) {
    Accounted accounted = new Accounted(String.valueOf(++lastOrder), order.feature(), listener);
    view.begun(accounted.conversation, order.feature());
    CallReporter reporter = new CallReporter(worker, view::understood, accounted);
    RatsLink.CallHandle handle =
        order.ends() ? link.end(order.to(member), reporter) : link.call(order.to(member), reporter);
    accounted.call = handle.callId();
    return handle;
  }

  /** The bid for features at the prices that the member's description states. */
  public Proposal bid(List<String> features) {
    if (!view.isReady()) {
      return new Proposal(member, Map.of(), Optional.of(member + " is not there"));
    }
    Map<String, Price> prices = new LinkedHashMap<>();
    features.forEach(
        name -> view.feature(name).ifPresent(feature -> prices.put(name, feature.cost())));
    return new Proposal(
        member,
        prices,
        prices.isEmpty() ? Optional.of(member + " has none of these features") : Optional.empty());
  }

  /**
   * Asks the member itself what a feature costs.
   *
   * @param answer told a quote for each set, in their order
   */
  public void quote(
      String feature, List<Map<String, Argument>> sets, Consumer<List<ContractNet.Quote>> answer) {
    link.cost(
        member,
        feature,
        sets.stream().map(MemberOrders::json).toList(),
        answers ->
            worker.execute(
                () -> answer.accept(answers.stream().map(MemberOrders::quote).toList())));
  }

  /**
   * Has the member tell once more what it says of itself.
   *
   * @param told is run once: it has, as far as it does so soon
   */
  public void tellAgain(Runnable told) {
    link.describe(
        member,
        clock.ofWallAtLeast(ANSWER_COMES),
        () -> clock.schedule(clock.ofWallAtLeast(STATE_COMES), member, () -> worker.execute(told)));
  }

  private static ContractNet.Quote quote(CostAnswer answer) {
    if (answer.cost().isPresent()) {
      double cost = answer.cost().get();
      return new ContractNet.Quote.Priced(cost, answer.seconds().orElse(cost));
    }
    String reason = answer.reason().orElse("no reason given");
    return answer.answered()
        ? new ContractNet.Quote.Declined(reason)
        : new ContractNet.Quote.Unanswered(reason);
  }

  private static Map<String, Object> json(Map<String, Argument> arguments) {
    return valued(arguments, JsonTerms::json);
  }

  private static <T> Map<String, T> valued(
      Map<String, Argument> arguments, Function<Argument, T> value) {
    Map<String, T> values = new TreeMap<>();
    arguments.forEach((name, argument) -> values.put(name, value.apply(argument)));
    return values;
  }

  /**
   * The reports of one call, each with its account. The good report of a member whose state may
   * still be on its way waits for that, a moment at most.
   */
  private final class Accounted implements CallReporter.Listener {
    private final String conversation;
    private final FeatureType feature;
    private final CallReporter.Listener listener;
    private String call = "";
    private Optional<Runnable> heldBack = Optional.empty();
    private boolean isOver;

    Accounted(String conversation, FeatureType feature, CallReporter.Listener listener) {
      this.conversation = conversation;
      this.feature = feature;
      this.listener = listener;
    }

    @Override
    public void reported(Outcome outcome, ActionDispatcher.Report report) {
      if (!report.succeeded() || !view.mayStillTellOf(call, feature)) {
        tell(outcome, report);
        return;
      }
      heldBack = Optional.of(() -> tell(outcome, report));
      Clock.Timer end =
          clock.schedule(
              clock.ofWallAtLeast(STATE_COMES), member, () -> worker.execute(this::goOn));
      view.whenItTellsOf(
          call,
          () -> {
            end.cancel();
            goOn();
          });
    }

    private void goOn() {
      Optional<Runnable> told = heldBack;
      heldBack = Optional.empty();
      told.ifPresent(Runnable::run);
      if (told.isPresent() && isOver) {
        over();
      }
    }

    private void tell(Outcome outcome, ActionDispatcher.Report report) {
      listener.reported(
          outcome, report.with(view.account(conversation, call, feature, report.succeeded())));
      view.over().ifPresent(say);
    }

    @Override
    public void learnt(Map<String, Term> outputs) {
      listener.learnt(outputs);
    }

    @Override
    public void alive() {
      listener.alive();
    }

    @Override
    public void alerted(String message) {
      listener.alerted(message);
    }

    @Override
    public void offered(String by, Offer offer) {
      listener.offered(by, offer);
    }

    @Override
    public void released(String reason) {
      listener.released(reason);
    }

    @Override
    public void over() {
      isOver = true;
      if (heldBack.isEmpty()) {
        view.forget(conversation);
        view.forgetCall(call);
        listener.over();
      }
    }
  }
}
