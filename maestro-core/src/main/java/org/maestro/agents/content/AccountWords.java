package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Moment;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.sl.Content;

/** The message format of accounts: what a member said of itself, and when by its own order. */
public final class AccountWords {
  private AccountWords() {}

  public static Content.Argument.Named of(StepAccount account) {
    List<Content.Argument> parts = new ArrayList<>();
    parts.add(Words.named("listener", Words.text(account.ended().listener())));
    parts.add(Words.named("begun", Words.number((double) account.begun().number())));
    parts.add(Words.named("ended", Words.number((double) account.ended().number())));
    account
        .last()
        .ifPresent(
            word -> {
              parts.add(Words.named("said", Words.number((double) word.moment().number())));
              parts.add(facts(word));
            });
    parts.add(Words.named("includesStep", Words.name(String.valueOf(account.includesStep()))));
    return Words.named("account", parts);
  }

  /** What a member says of itself. */
  public static List<Content.Argument> of(String member, MemberWord word) {
    List<Content.Argument> parts = new ArrayList<>();
    parts.add(Words.named("source", Words.name(member)));
    parts.add(Words.named("listener", Words.text(word.moment().listener())));
    parts.add(Words.named("said", Words.number((double) word.moment().number())));
    parts.add(facts(word));
    if (!word.isWhole()) {
      parts.add(Words.named("only", word.only().stream().sorted().map(Words::text).toList()));
    }
    return parts;
  }

  /** What a member is at. */
  public static Content condition(String member, MemberCondition now) {
    return Words.content(
        "inform",
        Words.named("member", Words.name(member)),
        Words.named("state", Words.text(now.state())),
        Words.named("busy", Words.name(String.valueOf(now.busy()))));
  }

  /** What {@link #condition} wrote; empty when it is something else. */
  public static Optional<MemberCondition> condition(Words words) {
    return words
        .string("state")
        .flatMap(
            state ->
                words
                    .string("busy")
                    .map(busy -> new MemberCondition(state, Boolean.parseBoolean(busy))));
  }

  private static Content.Argument.Named facts(MemberWord word) {
    return Words.named("facts", word.facts().stream().map(Words::text).toList());
  }

  /** What {@link #of} wrote, if somebody has listened. */
  public static Optional<StepAccount> account(Words report) {
    return report
        .find("account")
        .flatMap(
            words ->
                moment(words, "begun")
                    .flatMap(
                        begun ->
                            moment(words, "ended")
                                .map(
                                    ended ->
                                        new StepAccount(
                                            begun,
                                            ended,
                                            moment(words, "said").map(said -> word(words, said)),
                                            words
                                                .string("includesStep")
                                                .filter("true"::equals)
                                                .isPresent()))));
  }

  public static MemberWord word(Words words, Moment moment) {
    return new MemberWord(words.strings("facts"), moment, Set.copyOf(words.strings("only")));
  }

  public static Optional<Moment> moment(Words words, String name) {
    double number = words.number(name, -1);
    return number < 0
        ? Optional.empty()
        : words.string("listener").map(listener -> new Moment(listener, (long) number));
  }
}
