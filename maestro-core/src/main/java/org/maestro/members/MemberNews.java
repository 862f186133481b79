package org.maestro.members;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.ontology.home.Device;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads what the link tells of one member: that it described itself, what it says of itself, that
 * it was lost. One thread only: the one of whoever speaks for the member.
 */
public final class MemberNews {
  private static final Logger LOG = LoggerFactory.getLogger(MemberNews.class);

  /** The listener to the news of a member. */
  public interface Listener {

    /** It is there, and can be used as described. */
    void described(String description);

    /** What it says of itself cannot be read: it cannot be used until it says otherwise. */
    default void refused(RuntimeException why) {}

    /**
     * Facts about itself that can be read, none of them told while a call runs that may be changing
     * them. What it does not say any more is withdrawn.
     */
    void said(MemberWord word);

    void lost(String reason);
  }

  private final String member;
  private final MemberView view;
  private final BiFunction<String, String, Device> describedBy;
  private final Listener listener;
  private final SaidFacts saidFacts = new SaidFacts();
  private Optional<String> lastDescription = Optional.empty();
  private String boot = "";
  private boolean isRefused;
  private long statesHeard = -1;

  /**
   * @param describedBy reads a description (first argument) that a member (second) sent; throws a
   *     RuntimeException with one sentence when it is faulty
   */
  public MemberNews(
      String member,
      MemberView view,
      BiFunction<String, String, Device> describedBy,
      Listener listener) {
    this.member = member;
    this.view = view;
    this.describedBy = describedBy;
    this.listener = listener;
  }

  public void changed(RatsLink.Member now) {
    if (now.phase() == MemberStatus.Phase.READY) {
      if (view.isReady() && !boot.equals(now.boot())) {
        // It was gone for less than anybody has noticed; what it was at is over all the same.
        view.ready(false);
        listener.lost(member + " has begun anew");
      }
      boolean isBack = !view.isReady();
      now.description()
          .filter(text -> isBack && !isRefused || !isCurrent(text) || !boot.equals(now.boot()))
          .ifPresent(text -> describedAs(text, now.boot()));
      boolean isNews = statesHeard != now.statesHeard();
      statesHeard = now.statesHeard();
      if (isBack || isNews) {
        now.state().map(this::readable).flatMap(view::said).ifPresent(listener::said);
      }
      if (isNews && !isBack && now.state().isEmpty()) {
        view.saidNothing().ifPresent(listener::said);
      }
    } else if (now.phase() != MemberStatus.Phase.INIT && view.isReady()) {
      view.ready(false);
      listener.lost(member + " is " + now.phase().name().toLowerCase(Locale.ROOT));
    }
  }

  /** How descriptions are read has changed: the one that was heard last is read again. */
  public void readAgain() {
    if (view.isReady() || isRefused) {
      lastDescription.ifPresent(text -> describedAs(text, boot));
    }
  }

  /** Whether this is how the member describes itself now. */
  public boolean isCurrent(String description) {
    return lastDescription.equals(Optional.of(description));
  }

  /** The life that the member lives, as it was told last. */
  public String boot() {
    return boot;
  }

  private void describedAs(String description, String life) {
    lastDescription = Optional.of(description);
    boot = life;
    try {
      view.describedAs(describedBy.apply(description, member));
    } catch (RuntimeException e) {
      LOG.warn("The description of {} is refused: {}", member, DescriptionVerdict.inSentences(e));
      isRefused = true;
      view.ready(false);
      listener.refused(e);
      return;
    }
    isRefused = false;
    view.ready(true);
    listener.described(description);
  }

  private MemberState readable(MemberState state) {
    List<String> understood = state.values().stream().map(view::understood).toList();
    return state.with(saidFacts.readable(member, understood));
  }
}
