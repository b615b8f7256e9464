//! What a finger means: a tap, a long press, a drag or a scroll.
//!
//! egui takes a finger for a mouse, which means what it is over the moment it presses: a swipe that began on a field would put the
//! caret there and open the keyboard. So this holds the press back until the finger says what it wants. One that moves up or down
//! scrolls what lies below it; one that moves sideways drags, as a point of a chart is dragged; one that is lifted where it came down
//! taps; one that rests presses. With two fingers the browser zooms the page, and the program does nothing.
//!
//! To egui a scroll is a drag of the scroll area itself, so that it goes on by its own rules when the finger is lifted.

mod gesture;

use egui::{Context, Plugin, RawInput, Ui};
use gesture::{Gesture, HOLD, scroll_area_below};
use std::time::Duration;

pub use gesture::Touches;

impl Plugin for Touches {
    fn debug_name(&self) -> &'static str {
        "touches"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        let time = input.time.unwrap_or_else(|| ctx.input(|input| input.time));
        input.events = self.next(ctx, time, std::mem::take(&mut input.events));
    }

    fn on_begin_pass(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx();
        if !self.waiting.is_empty() || self.releases.is_some() {
            ctx.request_repaint();
        }
        if std::mem::take(&mut self.lets_go) {
            ctx.stop_dragging();
        }
        match &mut self.gesture {
            Gesture::None | Gesture::Pressing { .. } => {}
            Gesture::Held { passes, .. } => {
                // A finger that comes down holds what still moves.
                if *passes == 0
                    && let Some(area) = scroll_area_below(ctx)
                {
                    ctx.set_dragged_id(area);
                    ctx.stop_dragging();
                }
                *passes = passes.saturating_add(1);
                ctx.request_repaint_after(Duration::from_secs_f64(HOLD));
            }
            Gesture::Scrolling { area } => {
                *area = area.or_else(|| scroll_area_below(ctx));
                if let Some(area) = *area {
                    ctx.set_dragged_id(area);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::gesture::button;
    use super::*;
    use egui::{Event, Pos2, ScrollArea, Slider, TouchDeviceId, TouchId, TouchPhase, vec2};
    use egui_kittest::Harness;

    #[derive(Default)]
    struct Form {
        text: String,
        number: f32,
        offset: f32,
        clicks: usize,
        field: Option<Pos2>,
        slider: Option<Pos2>,
        button: Option<Pos2>,
    }

    /// A field, a slider and a button in a column that scrolls.
    struct Bench {
        harness: Harness<'static, Form>,
    }

    impl Bench {
        fn new() -> Self {
            let ui = |ui: &mut Ui, form: &mut Form| {
                let column = ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
                    ui.add_space(150.0);
                    let name = ui.label("Text").id;
                    form.field = Some(ui.text_edit_singleline(&mut form.text).labelled_by(name).rect.center());
                    let name = ui.label("Number").id;
                    let slider = Slider::new(&mut form.number, 0.0..=100.0).show_value(false);
                    form.slider = Some(ui.add(slider).labelled_by(name).rect.left_center() + vec2(8.0, 0.0));
                    let press = ui.button("Press");
                    form.clicks += usize::from(press.clicked());
                    form.button = Some(press.rect.center());
                    ui.add_space(2000.0);
                });
                form.offset = column.state.unclamped_offset().y;
            };
            let builder = Harness::builder()
                .with_size(vec2(300.0, 400.0))
                .with_step_dt(1.0 / 60.0)
                .with_context_setup(crate::app::theme::install);
            let mut harness = builder.build_ui_state(ui, Form::default());
            harness.ctx.add_plugin(Touches::default());
            harness.ctx.add_plugin(crate::app::batches::Batches::default());
            harness.step();
            Self { harness }
        }

        fn place(&self, of: impl Fn(&Form) -> Option<Pos2>) -> Pos2 {
            of(self.harness.state()).unwrap_or_default()
        }

        /// What eframe makes of a finger on the web: a pointer first. All in one frame, which `Harness::event` would not do.
        fn touch(&mut self, finger: u64, phase: TouchPhase, pos: Pos2) {
            let events = &mut self.harness.input_mut().events;
            match phase {
                TouchPhase::Start => events.push(button(pos, true)),
                TouchPhase::Move => events.push(Event::PointerMoved(pos)),
                TouchPhase::End => events.extend([button(pos, false), Event::PointerGone]),
                TouchPhase::Cancel => {}
            }
            events.push(Event::Touch {
                device_id: TouchDeviceId(0),
                id: TouchId(finger),
                phase,
                pos,
                force: None,
            });
        }

        /// A finger that moves in 10 steps, each a frame if `slowly`, and is lifted where it has come to rest.
        fn swipe(&mut self, from: Pos2, way: egui::Vec2, slowly: bool) {
            self.touch(0, TouchPhase::Start, from);
            for step in 1..=10_u8 {
                if slowly {
                    self.harness.step();
                }
                self.touch(0, TouchPhase::Move, from + way * f32::from(step) / 10.0);
            }
            self.harness.run_steps(if slowly { 20 } else { 1 });
            self.touch(0, TouchPhase::End, from + way);
            self.harness.run_steps(10);
        }

        fn tap(&mut self, at: Pos2) {
            self.touch(0, TouchPhase::Start, at);
            self.touch(0, TouchPhase::End, at);
            self.harness.run_steps(8);
        }

        fn is_focused(&self) -> bool {
            self.harness.ctx.memory(|memory| memory.focused().is_some())
        }
    }

    #[test]
    fn a_finger_that_moves_up_or_down_scrolls_whatever_it_began_on_and_focuses_nothing() {
        for from in [|form: &Form| form.field, |form: &Form| form.slider, |form: &Form| form.button] {
            let mut bench = Bench::new();
            bench.swipe(bench.place(from), vec2(10.0, -100.0), true);
            let form = bench.harness.state();
            assert!((form.offset - 100.0).abs() < 2.0, "{}", form.offset);
            assert!(form.number == 0.0 && form.clicks == 0 && !bench.is_focused());
        }
    }

    #[test]
    fn a_field_that_is_edited_is_scrolled_all_the_same_and_is_not_selected_from() {
        let mut bench = Bench::new();
        bench.tap(bench.place(|form| form.field));
        assert!(bench.is_focused());
        bench.harness.event(Event::Text("700".to_owned()));
        bench.harness.step();
        bench.swipe(bench.place(|form| form.field), vec2(-10.0, -100.0), true);
        bench.harness.event(Event::Text("5".to_owned()));
        bench.harness.step();
        let form = bench.harness.state();
        assert!((form.offset - 100.0).abs() < 2.0, "{}", form.offset);
        assert_eq!(form.text, "7005");
    }

    #[test]
    fn a_swipe_that_comes_in_one_frame_is_not_lost() {
        let mut bench = Bench::new();
        bench.swipe(bench.place(|form| form.field), vec2(0.0, -100.0), false);
        let offset = bench.harness.state().offset;
        assert!(offset >= 98.0, "{offset}");
        assert!(!bench.is_focused());
    }

    #[test]
    fn a_finger_that_moves_sideways_moves_a_slider_and_leaves_a_field() {
        let mut bench = Bench::new();
        bench.swipe(bench.place(|form| form.slider), vec2(60.0, 20.0), true);
        assert!(bench.harness.state().number > 30.0, "{}", bench.harness.state().number);
        assert!(bench.harness.state().offset == 0.0);
        let mut bench = Bench::new();
        bench.swipe(bench.place(|form| form.field), vec2(60.0, 0.0), true);
        assert!(!bench.is_focused());
    }

    #[test]
    fn a_tap_is_one_click_and_a_finger_that_rests_is_one_too() {
        let mut bench = Bench::new();
        let at = bench.place(|form| form.button);
        bench.tap(at);
        assert_eq!(bench.harness.state().clicks, 1);
        bench.touch(0, TouchPhase::Start, at);
        // 0.6 s in the 60 frames a second of the harness.
        bench.harness.run_steps(36);
        assert!(bench.harness.ctx.input(|input| input.pointer.any_down()));
        bench.touch(0, TouchPhase::End, at);
        bench.harness.run_steps(4);
        assert_eq!(bench.harness.state().clicks, 2);
    }

    #[test]
    fn two_fingers_and_one_that_the_system_takes_do_nothing() {
        let mut bench = Bench::new();
        let at = bench.place(|form| form.button);
        bench.touch(0, TouchPhase::Start, at);
        bench.harness.run_steps(3);
        bench.touch(1, TouchPhase::Start, at + vec2(30.0, 0.0));
        bench.touch(0, TouchPhase::Move, at - vec2(0.0, 90.0));
        bench.harness.run_steps(3);
        for finger in [1, 0] {
            bench.touch(finger, TouchPhase::End, at);
            bench.harness.run_steps(4);
        }
        // One that has pressed already.
        bench.touch(0, TouchPhase::Start, at);
        bench.harness.run_steps(36);
        bench.touch(0, TouchPhase::Cancel, at);
        bench.harness.run_steps(4);
        assert!(!bench.harness.ctx.input(|input| input.pointer.any_down()));
        let form = bench.harness.state();
        assert!(form.clicks == 0 && form.offset == 0.0);
        bench.tap(at);
        assert_eq!(bench.harness.state().clicks, 1, "the next tap counts");
    }

    #[test]
    fn a_mouse_is_left_alone() {
        let mut bench = Bench::new();
        let at = bench.place(|form| form.button);
        for event in [Event::PointerMoved(at), button(at, true), button(at, false)] {
            bench.harness.event(event);
            bench.harness.step();
        }
        assert_eq!(bench.harness.state().clicks, 1);
    }
}
