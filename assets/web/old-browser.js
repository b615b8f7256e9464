// Only browsers without JavaScript modules run this; they lack WebAssembly as this program needs it, too.
document.addEventListener('DOMContentLoaded', function () {
  document.getElementById('loading').hidden = true;
  document.getElementById('loading').style.display = 'none';
  document.getElementById('fatal-what').textContent = 'This browser is too old: it cannot load a WebAssembly program.';
  document.getElementById('fatal-todo').textContent = 'Use a current version of Firefox, Chrome, Edge or Safari.';
  document.getElementById('fatal').hidden = false;
});
