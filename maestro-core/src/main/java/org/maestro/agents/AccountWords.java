package org.maestro.agents;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.knowledge.MemberWord;
import org.maestro.knowledge.Moment;
import org.maestro.knowledge.StepAccount;
import org.maestro.sl.Content;

/** How agents tell each other what a member said of itself, and when by its own order. */
final class AccountWords {
  private AccountWords() {}

  static Content.Argument.Named of(StepAccount account) {
    List<Content.Argument> parts = new ArrayList<>();
    parts.add(Words.named("listener", Words.text(account.ended().listener())));
    parts.add(Words.named("begun", Words.number(account.begun().number())));
    parts.add(Words.named("ended", Words.number(account.ended().number())));
    account
        .last()
        .ifPresent(
            word -> {
              parts.add(Words.named("said", Words.number(word.moment().number())));
              parts.add(facts(word));
            });
    parts.add(Words.named("includesStep", Words.name(String.valueOf(account.includesStep()))));
    return Words.named("account", parts);
  }

  static Content.Argument.Named facts(MemberWord word) {
    return Words.named("facts", word.facts().stream().map(Words::text).toList());
  }

  /** What {@link #of} wrote, if somebody has listened. */
  static Optional<StepAccount> account(Words report) {
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

  static MemberWord word(Words words, Moment moment) {
    return new MemberWord(
        words.find("facts").map(Words::terms).orElse(List.of()).stream().map(Words::plain).toList(),
        moment);
  }

  static Optional<Moment> moment(Words words, String name) {
    double number = words.number(name, -1);
    return number < 0
        ? Optional.empty()
        : words.string("listener").map(listener -> new Moment(listener, (long) number));
  }
}
