package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.maestro.agents.calls.Pointers;
import org.maestro.agents.content.AccountWords;
import org.maestro.agents.content.BeliefWords;
import org.maestro.agents.content.VerdictWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.device.ToldRights;
import org.maestro.agents.knowledge.BeliefSubscriptions;
import org.maestro.agents.knowledge.KnowledgeSubscriptions;
import org.maestro.agents.knowledge.Readers;
import org.maestro.agents.knowledge.ToldFacts;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.PartGuard;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.knowledge.Question;
import org.maestro.knowledge.QuestionReader;
import org.maestro.knowledge.api.Answer;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Moment;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.knowledge.habits.Habits;
import org.maestro.ontology.home.DescriptionCheck;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Part;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.ontology.home.WordList;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * The way to the collective knowledge for agents everywhere (Three-layered architecture, 2; M12,
 * M15): they tell it, ask it and subscribe to it in MAESTRO-SL.
 *
 * <pre>
 * (inform (:source rose) (:facts "(in rose zone-b)" ...))
 * (query-if (in Cup zone-b))                   true, false or unknown, how old, on whose word
 * (query-if (in Cup zone-b) (:within 60))      by nothing older than 60 s
 * (query-ref (in Cup ?where))                  an element for each answer; (:answers none)
 * (query-ref (= (level lamp-1) ?n))            the number; (query-ref (level lamp-1)) too
 * (query-ref)                                  all that is believed
 * (query-ref (:history "(in Cup zone-b)"))     who said what of it, when and how surely
 * (query-ref (:last "(in Cup zone-b)"))        what was known of it last, however long ago
 * (query-ref (:call (:member cam-1) (:feature observeObject) (:parameters (:object Cup))))
 *                                              what the member needs to know of what a call names
 * (query-ref (:disputes))                      on what sources disagree, and how that was settled
 * (subscribe (in Cup ?where))                  AGREE, what is so now, and again when that changes;
 *                                              until CANCEL in the same conversation
 * (subscribe (:beliefs))                       the same of all that is believed, for a copy of it
 * </pre>
 *
 * A question that uses words as neither home nor vocabulary do is refused, as a goal is; so is one
 * in private words from who may not read them. Lists leave their facts out, and say last how many:
 * {@code (inform (:left-out 2) (:reason "..."))}. The desk asks for a person by {@code (:for
 * "alice")}.
 */
public final class KnowledgeAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  private static final int MILLIS_PER_SECOND = 1_000;
  private static final Source OF_THE_HOME = new Source(Source.Kind.DESCRIBED, Source.HOME);

  private final transient KnowledgeBase knowledge;
  private final transient BiFunction<String, String, Device> describedBy;
  private final transient ToldFacts toldFacts = new ToldFacts();
  private final transient KnowledgeSubscriptions subscriptions =
      new KnowledgeSubscriptions(
          this::inform, (request, reason) -> refuse(request, ACLMessage.REFUSE, reason));
  private final transient BeliefSubscriptions copies =
      new BeliefSubscriptions((message, news) -> answer(message, news.stream()));

  private final transient Habits habits;
  private final transient Readers readers;
  private final transient Spokesmen spokesmen;
  private final transient PartGuard parts;
  private final transient ToldRights told;

  private transient Clock.Timer review = () -> {};

  /**
   * One that remembers no habits beyond its own end, and believes of each member the agent of its
   * name.
   */
  public KnowledgeAgent(
      Birth birth,
      AgentTime time,
      KnowledgeBase knowledge,
      BiFunction<String, String, Device> describedBy) {
    this(birth, time, knowledge, describedBy, HabitLog.NONE, Spokesmen.BY_NAME);
  }

  /**
   * @param habitLog remembers what is counted
   * @param spokesmen who is believed what he tells of members
   */
  public KnowledgeAgent(
      Birth birth,
      AgentTime time,
      KnowledgeBase knowledge,
      BiFunction<String, String, Device> describedBy,
      HabitLog habitLog,
      Spokesmen spokesmen) {
    super(birth, time);
    this.knowledge = knowledge;
    this.describedBy = describedBy;
    this.habits = new Habits(knowledge, time.clock(), habitLog);
    this.readers = new Readers(knowledge::home);
    this.spokesmen = spokesmen;
    this.parts = new PartGuard(this, knowledge::home, spokesmen);
    this.told = new ToldRights(this, knowledge::home);
  }

  @Override
  protected void setup() {
    super.setup();
    knowledge.watch(
        change -> {
          if (change.source().equals(OF_THE_HOME)) {
            tell(told::changed);
          }
          if (!subscriptions.isEmpty()) {
            tell(() -> subscriptions.changed(knowledge.snapshot()));
          }
          if (!copies.isEmpty()) {
            tell(() -> copies.changed(change, knowledge.snapshot()));
          }
          if (habits.concerns(change)) {
            tell(habits::look);
          }
        });
    if (habits.areAny()) {
      habits.begin();
      reviewHabits();
    }
  }

  @Override
  protected void takeDown() {
    review.cancel();
    super.takeDown();
  }

  /** What is a habit in the evening is none in the morning. */
  private void reviewHabits() {
    review =
        clock()
            .schedule(
                Habits.BETWEEN_REVIEWS,
                getLocalName(),
                () ->
                    tell(
                        () -> {
                          habits.tell();
                          reviewHabits();
                        }));
  }

  @Override
  protected void received(ACLMessage message) {
    if (message.getPerformative() == ACLMessage.CANCEL) {
      cancel(message);
      return;
    }
    for (Content content : Words.parse(message.getContent())) {
      try {
        received(message, content);
      } catch (KnowledgeException e) {
        refuse(message, e);
      }
    }
  }

  private void refuse(ACLMessage message, RuntimeException why) {
    String sentence = Objects.requireNonNullElse(why.getMessage(), why.toString());
    refuse(message, ACLMessage.REFUSE, sentence);
  }

  private void received(ACLMessage message, Content content) {
    Words words = Words.of(content);
    Optional<Part> part = part(content.operator());
    if (part.isPresent() && !parts.admits(message, words, part.get())) {
      return;
    }
    switch (content.operator()) {
      case "inform" -> informed(message, words);
      case "query-if" -> queryIf(message, words);
      case "query-ref" -> queryRef(message, words);
      case "subscribe" -> subscribe(message, words);
      default ->
          refuse(
              message,
              ACLMessage.NOT_UNDERSTOOD,
              "The knowledge agent does not know the operator "
                  + content.operator()
                  + "; it knows inform, query-if, query-ref and subscribe.");
    }
  }

  private static Optional<Part> part(String operator) {
    return switch (operator) {
      case "inform" -> Optional.of(Part.TELLING);
      case "query-if", "query-ref", "subscribe" -> Optional.of(Part.MEMORY);
      default -> Optional.empty();
    };
  }

  private void informed(ACLMessage message, Words words) {
    Optional<String> forged = spokenFor(message, words);
    if (forged.isPresent()) {
      refuse(message, ACLMessage.REFUSE, forged.get());
      return;
    }
    List<Content.Argument> answer = new ArrayList<>();
    answer.add(Words.named("done", Words.name("noted")));
    if (words.string("description").isPresent()) {
      Device device =
          describedBy.apply(words.string("description").get(), words.string("member").orElse(""));
      knowledge.describe(device);
      answer.addAll(told.introduced(device, message.getSender()));
    } else if (AccountWords.condition(words).isPresent()) {
      words
          .string("member")
          .filter(knowledge.home().devices()::containsKey)
          .ifPresent(
              member -> knowledge.condition(member, AccountWords.condition(words).orElseThrow()));
    } else if (words.find("facts").isPresent()) {
      state(words.string("source").orElse("unnamed"), words);
    } else {
      learn(words);
    }
    if (message.getPerformative() == ACLMessage.REQUEST) {
      reply(message, ACLMessage.INFORM, new Content("inform", answer));
    }
  }

  /** Who does not count what is heard of the speaker is believed in the order of arrival. */
  private void state(String speaker, Words words) {
    Optional<Moment> moment = AccountWords.moment(words, "said");
    MemberWord word = AccountWords.word(words, moment.orElse(new Moment(speaker, 0)));
    List<String> possible = toldFacts.possible(speaker, word.facts(), knowledge.home());
    if (moment.isPresent()) {
      knowledge.state(speaker, new MemberWord(possible, word.moment(), word.only()));
    } else {
      knowledge.state(new Source(Source.Kind.STATED, speaker), possible);
    }
  }

  /** Nobody but its own agent speaks for a device, and introduces one (A23). */
  private Optional<String> spokenFor(ACLMessage message, Words words) {
    boolean isIntroduced = words.string("description").isPresent();
    return words
        .string("source")
        .or(() -> words.string("member"))
        .filter(source -> isIntroduced || knowledge.home().devices().containsKey(source))
        .flatMap(source -> spokesmen.objection(Caller.of(message), source));
  }

  private void learn(Words words) {
    String member = words.string("member").orElse("");
    String name = words.string("feature").orElse("");
    Map<String, Term> bindings = Self.is(member, words.termsOf("bindings"));
    Optional.ofNullable(knowledge.home().devices().get(member)).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(name))
        .filter(feature -> isBound(feature, bindings))
        .findFirst()
        .ifPresent(
            feature ->
                knowledge.learn(
                    new FeatureRun(
                        member, feature, bindings, true, words.termsOf("outputs"), List.of())));
  }

  /** Who orders by hand may leave out what a plan would have bound; then nothing can be learnt. */
  private static boolean isBound(FeatureType feature, Map<String, Term> bindings) {
    return feature.binds().stream().map(Parameter::name).allMatch(bindings::containsKey);
  }

  private ReadingRights rights(ACLMessage message, Words words) {
    return readers.of(Caller.of(message).askingFor(words.string("for")));
  }

  private void queryIf(ACLMessage message, Words words) {
    Optional<Formula> formula = question(message, words);
    if (formula.isEmpty()) {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "A question needs a formula, such as (query-if (in Cup zone-b)).");
      return;
    }
    inform(
        message,
        List.of(new Question(read(words), rights(message, words)).answerIf(formula.get())));
  }

  private void queryRef(ACLMessage message, Words words) {
    Snapshot snapshot = read(words);
    ReadingRights rights = rights(message, words);
    Optional<String> history = words.string("history").map(fact -> fact(fact, rights));
    Optional<String> last = words.string("last").map(fact -> fact(fact, rights));
    Optional<Formula> question = question(message, words);
    if (words.find("call").isPresent()) {
      call(message, words.find("call").get(), rights);
    } else if (history.isPresent()) {
      Instant limit = within(words).map(snapshot.at()::minus).orElse(Instant.MIN);
      beliefs(
          message,
          knowledge.history(history.get()).stream()
              .filter(belief -> !belief.since().isBefore(limit)),
          snapshot.at());
    } else if (last.isPresent()) {
      beliefs(message, knowledge.lastKnown(last.get()).stream(), snapshot.at());
    } else if (words.named("disputes").isPresent()) {
      list(
          message,
          snapshot.disputes(),
          dispute -> isTold(dispute, rights),
          dispute -> BeliefWords.content(dispute, snapshot.at()));
    } else if (words.named("words").isPresent()) {
      answer(message, WordList.of(knowledge.home()).stream().map(KnowledgeAgent::word));
    } else if (words.find("description").isPresent()) {
      checkDescription(message, words);
    } else if (question.isPresent()) {
      inform(message, new Question(snapshot, rights).answerRef(question.get()));
    } else if (words.hasNothingBut("within", "for")) {
      list(
          message,
          snapshot.beliefs(),
          belief -> rights.mayReadFact(belief.fact()),
          belief -> BeliefWords.content(belief, snapshot.at()));
    } else {
      throw new KnowledgeException(
          "A question needs a formula, such as (query-ref (in Cup ?where)), or one of :history,"
              + " :last, :call, :disputes, :words and :description.");
    }
  }

  /** What would become of a description; nobody joins by it. */
  private void checkDescription(ACLMessage message, Words words) {
    answer(
        message,
        VerdictWords.contents(
            new DescriptionCheck(knowledge.home(), describedBy)
                .check(
                    words.string("description").orElse(""),
                    words.string("source").orElse("the description"))));
  }

  private static Content word(WordList.Entry entry) {
    return Words.content(
        "word",
        Words.named("kind", Words.text(entry.kind())),
        Words.named("form", Words.text(entry.form())),
        Words.named("meaning", Words.text(entry.meaning())),
        Words.named("unit", Words.text(entry.unit())),
        Words.named("devices", entry.devices().stream().map(Words::text).toList()));
  }

  private QuestionReader reader() {
    return new QuestionReader(knowledge.home());
  }

  private Optional<Formula> question(ACLMessage message, Words words) {
    Optional<Formula> question = words.formula().map(reader()::question);
    requireNone(question.flatMap(rights(message, words)::objection));
    return question;
  }

  private String fact(String asked, ReadingRights rights) {
    String fact = reader().fact(asked);
    requireNone(rights.objectionToFact(fact));
    return fact;
  }

  private static void requireNone(Optional<String> objection) {
    objection.ifPresent(
        sentence -> {
          throw new KnowledgeException(sentence);
        });
  }

  private static boolean isTold(Dispute dispute, ReadingRights rights) {
    return Stream.concat(
            dispute.believed().stream(), dispute.losers().stream().map(Dispute.Loser::belief))
        .allMatch(belief -> rights.mayReadFact(belief.fact()));
  }

  /** The agent of a member is told what the member needs. */
  private void call(ACLMessage message, Words call, ReadingRights rights) {
    boolean isItsOwn = call.string("member").filter(Caller.of(message).agent()::equals).isPresent();
    try {
      reply(
          message,
          ACLMessage.INFORM,
          Pointers.answer(knowledge, call, isItsOwn ? ReadingRights.ALL : rights));
    } catch (Pointers.UnknownThing e) {
      refuse(message, e);
    }
  }

  private void subscribe(ACLMessage message, Words words) {
    if (words.named("beliefs").isPresent()) {
      reply(
          message, ACLMessage.AGREE, Words.content("subscribe", Words.named("beliefs", List.of())));
      copies.add(message, rights(message, words), knowledge.snapshot());
      return;
    }
    Optional<Formula> formula = question(message, words);
    if (formula.isEmpty()) {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "A subscription needs a formula, such as (subscribe (in Cup ?where)).");
      return;
    }
    reply(message, ACLMessage.AGREE, Words.content("subscribe", Words.formula(formula.get())));
    subscriptions.add(
        message, formula.get(), within(words), () -> rights(message, words), knowledge.snapshot());
  }

  private void cancel(ACLMessage message) {
    if (subscriptions.cancel(message) || copies.cancel(message)) {
      reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("done", Words.name("cancelled"))));
    } else {
      refuse(
          message,
          ACLMessage.FAILURE,
          "There is no subscription of yours in this conversation; name the one you began it in.");
    }
  }

  private Snapshot read(Words words) {
    Snapshot now = knowledge.snapshot();
    return within(words).map(now::notOlderThan).orElse(now);
  }

  /** How old what counts may be. */
  private static Optional<Duration> within(Words words) {
    if (words.named("within").isEmpty()) {
      return Optional.empty();
    }
    double seconds = words.number("within", -1);
    if (seconds < 0) {
      throw new KnowledgeException(
          "What follows :within is no number of seconds; write one, such as (:within 60).");
    }
    return Optional.of(Duration.ofMillis((long) (seconds * MILLIS_PER_SECOND)));
  }

  private void inform(ACLMessage message, List<Answer> answers) {
    answer(message, answers.stream().map(BeliefWords::content));
  }

  private void beliefs(ACLMessage message, Stream<Belief> beliefs, Instant now) {
    answer(message, beliefs.map(belief -> BeliefWords.content(belief, now)));
  }

  /** A list, without what is kept from who asks; how much that is, is told. */
  private <T> void list(
      ACLMessage message, List<T> all, Predicate<T> isTold, Function<T, Content> words) {
    List<T> told = all.stream().filter(isTold).toList();
    int leftOut = all.size() - told.size();
    answer(
        message,
        Stream.concat(
            told.stream().map(words),
            leftOut == 0
                ? Stream.empty()
                : Stream.of(
                    Words.content(
                        "inform",
                        Words.named("left-out", Words.number(leftOut)),
                        Words.named("reason", Words.text(ReadingRights.leftOut(leftOut)))))));
  }

  /** No message is empty: that there is nothing to tell is an answer too. */
  private void answer(ACLMessage message, Stream<Content> elements) {
    List<Content> all = elements.toList();
    reply(
        message,
        ACLMessage.INFORM,
        all.isEmpty()
            ? new Content[] {Words.content("inform", Words.named("answers", Words.name("none")))}
            : all.toArray(Content[]::new));
  }
}
