package org.maestro.assembly;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.maestro.coordination.Coordinator;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.members.MemberNews;
import org.maestro.members.MemberOrders;
import org.maestro.members.MemberView;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * Proxies of the members where no agents speak for them: each tells the knowledge and the
 * coordinator what its member tells. Clock thread only.
 */
final class Deputies {
  private final Clock clock;
  private final KnowledgeBase knowledge;
  private final BiFunction<String, String, Device> describedBy;
  private final Map<String, Deputy> deputies = new TreeMap<>();
  private final RatsLink link;

  Deputies(
      RatsLink link,
      Clock clock,
      KnowledgeBase knowledge,
      BiFunction<String, String, Device> describedBy) {
    this.link = link;
    this.clock = clock;
    this.knowledge = knowledge;
    this.describedBy = describedBy;
  }

  /** Begins to tell what members tell. */
  void report(Coordinator coordinator) {
    link.watch(
        member ->
            later(
                member.id(),
                () ->
                    deputies
                        .computeIfAbsent(member.id(), id -> new Deputy(id, coordinator))
                        .news
                        .changed(member)));
  }

  Optional<Deputy> of(String member) {
    return Optional.ofNullable(deputies.get(member)).filter(deputy -> deputy.view.isReady());
  }

  /** An event of its own, so that nothing changes under the feet of who caused it. */
  void later(String owner, Runnable action) {
    clock.schedule(Duration.ZERO, owner, action);
  }

  final class Deputy implements MemberNews.Listener {
    private final String member;
    private final Coordinator coordinator;
    private final MemberView view;
    private final MemberNews news;
    private final MemberOrders orders;

    private Deputy(String member, Coordinator coordinator) {
      this.member = member;
      this.coordinator = coordinator;
      this.view = new MemberView(member, () -> link.describe(member));
      this.news = new MemberNews(member, view, describedBy, this);
      this.orders =
          new MemberOrders(member, link, view, action -> later(member, action), clock, this::said);
    }

    MemberOrders orders() {
      return orders;
    }

    @Override
    public void described(String description) {
      view.device().ifPresent(knowledge::describe);
      coordinator.memberPresent(member, Optional.of(news.boot()));
    }

    @Override
    public void said(MemberWord word) {
      knowledge.state(member, word);
    }

    @Override
    public void lost(String reason) {
      coordinator.memberLost(member, reason);
    }

    /** What one more value set of a stream teaches. */
    void learnt(FeatureType feature, Map<String, Term> bindings, Map<String, Term> outputs) {
      Map<String, Term> all = Self.is(member, bindings);
      knowledge.learn(new FeatureRun(member, feature, all, true, outputs, List.of()));
    }
  }
}
