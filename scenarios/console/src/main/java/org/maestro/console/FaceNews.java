package org.maestro.console;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * What faces tell, for pages each of which shows one of them, and which faces are shown so. Any
 * thread may use it.
 */
final class FaceNews implements EventSource {
  private final EventSource news;
  private final Map<EventQueue, String> shown = new ConcurrentHashMap<>();

  FaceNews(EventSource news) {
    this.news = news;
  }

  /** Whether a page shows the face of that member now. */
  boolean isShown(String member) {
    return shown.containsValue(member);
  }

  @Override
  public void listen(EventQueue listener, Runnable then) {
    news.listen(listener, then);
  }

  @Override
  public void leave(EventQueue listener) {
    news.leave(listener);
  }

  /** Who asks for one face shows that one. */
  @Override
  public EventSource of(String member) {
    return new EventSource() {
      @Override
      public void listen(EventQueue listener, Runnable then) {
        if (!member.isEmpty()) {
          shown.put(listener, member);
        }
        news.listen(listener, then);
      }

      @Override
      public void leave(EventQueue listener) {
        shown.remove(listener);
        news.leave(listener);
      }
    };
  }
}
